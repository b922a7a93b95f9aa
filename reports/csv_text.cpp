#include "reports/csv_text.hpp"

#include <fmt/format.h>

namespace superstep {

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

std::string csv_cell(double value) {
  return fmt::format("{}", value);
}

}  // namespace superstep
