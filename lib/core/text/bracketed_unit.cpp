#include "core/text/bracketed_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "core/text/text_file.hpp"

namespace superstep {

NameAndUnit split_bracketed_unit(std::string_view written) noexcept {
  written = trimmed(written);
  const std::size_t open = written.find_last_of("[(");
  const bool closed = !written.empty() && (written.back() == ']' || written.back() == ')');
  if (!closed || open == std::string_view::npos) return {written, {}};
  return {trimmed(written.substr(0, open)), trimmed(written.substr(open + 1, written.size() - open - 2))};
}

bool is_plain_unit(std::string_view unit) noexcept {
  constexpr std::array<std::string_view, 17> plain = {"m",   "s",   "sec", "second", "seconds", "K",
                                                      "V",   "W",   "A",   "S",      "F",       "J/K",
                                                      "W/K", "A/V", "kg",  "-",      "1"};
  return std::find(plain.begin(), plain.end(), unit) != plain.end();
}

void require_plain_unit(std::string_view written, const std::string& where) {
  const auto [name, unit] = split_bracketed_unit(written);
  if (unit.empty() || is_plain_unit(unit)) return;
  throw InputError(
      fmt::format("{}: column {} is in {}; numbers are taken in SI units: convert them, and call it '{}'",
                  where, in_quotes(written), unit, name));
}

}  // namespace superstep
