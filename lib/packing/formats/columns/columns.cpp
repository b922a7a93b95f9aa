#include "packing/formats/columns/columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/text/delimited.hpp"
#include "core/text/suggest.hpp"
#include "packing/formats/columns/find_positions.hpp"

namespace superstep {
namespace {

bool is_one_of(std::size_t column, const SphereColumns::Axes& axes) {
  return std::find(axes.begin(), axes.end(), column) != axes.end();
}

/// Units behind the names: for all lengths or for none, and one for positions.
void find_units(const ColumnFinder& finder, SphereColumns& columns) {
  std::vector<std::optional<double>> of_positions, of_sizes;
  for (const std::size_t column : columns.position)
    if (column != SphereColumns::none) of_positions.push_back(finder.unit(column));
  for (const std::size_t column : {columns.radius, columns.diameter})
    if (column != SphereColumns::none) of_sizes.push_back(finder.unit(column));
  const auto states = [](const auto& unit) { return unit.has_value(); };
  if (std::none_of(of_positions.begin(), of_positions.end(), states) &&
      std::none_of(of_sizes.begin(), of_sizes.end(), states))
    return;
  const auto unit = of_positions.front();
  if (!unit ||
      std::count(of_positions.begin(), of_positions.end(), unit) !=
          static_cast<std::ptrdiff_t>(of_positions.size()) ||
      !std::all_of(of_sizes.begin(), of_sizes.end(), states))
    throw InputError(
        fmt::format("{}: the columns of lengths state units for some of them only, or different ones for "
                    "x, y and z; state one for all, or none and give length_unit",
                    finder.place()));
  columns.unit = unit;
  columns.radius_unit = finder.unit(columns.radius).value_or(*unit) / *unit;
  columns.diameter_unit = finder.unit(columns.diameter).value_or(*unit) / *unit;
  columns.second_unit = finder.unit(columns.second_position[0]).value_or(*unit) / *unit;
}

void list_the_others(std::span<const std::string> names, SphereColumns& columns) {
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (std::any_of(columns.repeated.begin(), columns.repeated.end(),
                    [k](const auto& one) { return one.second == k; }))
      continue;
    const std::string name = lower_case(names[k]);
    if (name.empty() || name.starts_with("unnamed: "))
      columns.row_numbers.push_back(k);
    else if (k != columns.id && !is_one_of(k, columns.position) && k != columns.radius &&
             k != columns.diameter && k != columns.material)
      columns.attributes.push_back(k);
  }
}

}  // namespace

SphereColumns find_sphere_columns(std::span<const std::string> names, const ColumnRules& rules,
                                  const std::string& place, const std::string& header) {
  const ColumnFinder finder(names, rules, place, header);
  SphereColumns columns;
  columns.repeated = finder.repeated();
  find_positions(finder, columns);
  columns.radius = finder.find(radius_names());
  columns.diameter = finder.find(diameter_names());
  if (columns.radius == SphereColumns::none && columns.diameter == SphereColumns::none) {
    auto candidates = radius_names();
    candidates.insert(candidates.end(), diameter_names().begin(), diameter_names().end());
    finder.missing("radius", candidates);
  }
  columns.id = finder.find(id_names());
  columns.material = finder.find(material_names());
  columns.material_is_number =
      columns.material != SphereColumns::none && lower_case(names[columns.material]) != "material";
  find_units(finder, columns);
  list_the_others(names, columns);
  return columns;
}

const HeaderRule& sphere_header_rule() {
  static const HeaderRule rule{[](std::string_view name) { return !usual_meaning(name).empty(); },
                               [](const std::vector<std::string>& names) {
                                 return std::any_of(names.begin(), names.end(), [](const std::string& name) {
                                   const std::string meaning = usual_meaning(name);
                                   return meaning == "radius" || meaning == "diameter";
                                 });
                               }};
  return rule;
}

bool names_a_position(std::span<const std::string> names) {
  std::vector<std::string> plain;
  for (const auto& name : names) plain.push_back(plain_name(name).name);
  const auto is_there = [&](const std::string& name) {
    return std::find(plain.begin(), plain.end(), name) != plain.end();
  };
  return std::any_of(coordinate_names().begin(), coordinate_names().end(),
                     [&](const auto& one) { return std::all_of(one.begin(), one.end(), is_there); });
}

std::string likely_misspelling(const std::string& name) {
  static const std::vector<std::string> words = {"material"};
  const std::string plain = plain_name(name).name;
  return plain.size() < 6 || plain == words[0] ? std::string{} : nearest_by_spelling(plain, words);
}

}  // namespace superstep
