#include "core/text/bracketed_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/error.hpp"
#include "core/text/delimited.hpp"
#include "core/text/text_file.hpp"

namespace superstep {

NameAndUnit split_bracketed_unit(std::string_view written) noexcept {
  written = trimmed(written);
  const std::size_t open = written.find_last_of("[(");
  const bool closed = !written.empty() && (written.back() == ']' || written.back() == ')');
  if (!closed || open == std::string_view::npos) return {written, {}};
  return {trimmed(written.substr(0, open)), trimmed(written.substr(open + 1, written.size() - open - 2))};
}

std::string bare_name(std::string_view written) {
  return lower_case(split_bracketed_unit(written).name);
}

std::optional<std::size_t> place_of_name(std::span<const std::string> names, std::string_view wanted,
                                         const std::string& where) {
  const auto find = [&](auto same) {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < names.size(); ++k)
      if (same(names[k])) found.push_back(k);
    if (found.size() > 1)
      throw InputError(fmt::format("{}: {} may be column {} or {}; rename one of them", where,
                                   in_quotes(wanted), in_quotes(names[found[0]]),
                                   in_quotes(names[found[1]])));
    return found.empty() ? std::nullopt : std::optional(found.front());
  };
  if (auto place = find([&](const std::string& name) { return name == wanted; })) return place;
  if (auto place = find([&](const std::string& name) { return split_bracketed_unit(name).name == wanted; }))
    return place;
  if (auto place = find([&](const std::string& name) { return lower_case(name) == lower_case(wanted); }))
    return place;
  return find([&](const std::string& name) { return bare_name(name) == bare_name(wanted); });
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
