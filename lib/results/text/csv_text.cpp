#include "results/text/csv_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace superstep {
namespace {

constexpr std::string_view formula_starts = "=+-@\t\r\n";

// Apostrophes that stand there already count as part of the formula, so that reading back undoes writing.
bool looks_like_formula(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of('\''), text.size()));
  return !text.empty() && formula_starts.find(text.front()) != std::string_view::npos;
}

}  // namespace

std::string csv_cell(std::string_view text) {
  std::string out = looks_like_formula(text) ? "'" : "";
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return out.append(text);
  out.insert(out.begin(), '"');
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

std::string csv_cell(double value) {
  return fmt::format("{}", value);
}

std::string csv_text_of(std::string_view cell) {
  const bool guarded = cell.starts_with('\'') && looks_like_formula(cell.substr(1));
  return std::string(guarded ? cell.substr(1) : cell);
}

}  // namespace superstep
