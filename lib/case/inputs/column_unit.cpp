#include "case/inputs/column_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/error.hpp"
#include "core/text/delimited.hpp"

namespace superstep {
namespace {

/// Words that are units also where no brackets say so.
constexpr std::array<std::string_view, 10> clear_units = {
    "degc", "\xC2\xB0\x63", "celsius", "degf", "fahrenheit", "mk", "kelvin", "mv", "kv", "volt"};

bool is_name_of(std::string_view written, std::string_view unit) {
  const std::string word = lower_case(written);
  if (unit == "K") return written == "K" || word == "kelvin";
  return written == "V" || word == "volt" || word == "volts";
}

}  // namespace

NameAndUnit split_column_unit(std::string_view written) {
  const NameAndUnit split = split_bracketed_unit(written);
  const bool is_index = split.unit.find_first_not_of("0123456789") == std::string_view::npos;  // f_Temp[0]
  if (!split.unit.empty()) return is_index ? NameAndUnit{trimmed(written), {}} : split;
  const std::size_t cut = split.name.find_last_of("_ ");
  if (cut == std::string_view::npos) return split;
  const std::string_view before = split.name.substr(0, cut), last = split.name.substr(cut + 1);
  const std::string name = lower_case(before);
  const bool is_celsius = last == "C" && (name == "t" || name.find("temp") != std::string::npos);
  const bool is_clear =
      std::find(clear_units.begin(), clear_units.end(), lower_case(last)) != clear_units.end();
  return is_celsius || is_clear ? NameAndUnit{before, last} : split;
}

void require_column_unit(std::string_view name, std::string_view unit, const std::string& where) {
  const std::string_view stated = split_column_unit(name).unit;
  if (stated.empty()) return;
  const bool is_known =
      unit.empty() ? is_name_of(stated, "K") || is_name_of(stated, "V") : is_name_of(stated, unit);
  if (is_known) return;
  throw InputError(
      fmt::format("{}: column '{}' is in {}; its values are taken in {}: convert them, or name another "
                  "column",
                  where, name, stated, unit.empty() ? "K or V" : unit));
}

HeaderRule or_states_unit(HeaderRule rule, std::string_view unit_of(std::string_view name)) {
  rule.is_header = [names_them = std::move(rule.is_header), unit_of](const std::vector<std::string>& names) {
    return names_them(names) ||
           std::any_of(names.begin(), names.end(), [&](const auto& name) { return !unit_of(name).empty(); });
  };
  return rule;
}

}  // namespace superstep
