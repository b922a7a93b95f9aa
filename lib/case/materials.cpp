#include "case/materials.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case/read_conductivity.hpp"
#include "core/error.hpp"
#include "core/text/suggest.hpp"

namespace superstep {
namespace {

Interface read_interface(TomlTable table) {
  const Interface interface {
    .thickness = table.positive("thickness", "m"), .reduction = table.positive("reduction", "-")
  };
  table.finish();
  return interface;
}

Conduction read_conduction(TomlTable& table, const std::string& capacity_key) {
  Conduction conduction{.conductivity = read_conductivity(
                            table.require("conductivity", "it is a number or a law of temperature"))};
  if (!capacity_key.empty())
    conduction.capacity = table.positive(capacity_key, capacity_key == "specific_heat" ? "J/(kg K)" : "F/kg");
  return conduction;
}

std::int32_t material_index(const TomlValue& name, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name.string());
  if (found == names.end())
    name.reject("it must be the name of one of [[materials]]" + suggestion(name.string(), names));
  return static_cast<std::int32_t>(found - names.begin());
}

}  // namespace

Interface FieldMaterials::interface(std::int32_t a, std::int32_t b) const {
  const std::pair key(std::min(a, b), std::max(a, b));
  for (const auto& [pair, interface] : between)
    if (pair == key) return interface;
  return grain_boundary;
}

Materials::Materials(TomlTable& root, const Packing& packing) {
  const auto several = root.find("materials");
  if (!several) {
    auto one = root.table("material");
    if (!one)
      throw InputError(
          fmt::format("{}: [material] is missing; give at least its density [kg/m3]", root.where()));
    density_.assign(std::max<std::size_t>(1, packing.material_names.size()),
                    one->positive("density", "kg/m3"));
    return;
  }
  if (root.find("material")) several->reject("give either [material] or [[materials]], not both");
  names_ = packing.material_names;
  if (names_.empty())
    several->reject("the packing has no material column; add one, or give a single [material]");
  std::vector<std::string> given;
  std::vector<TomlTable> tables;
  for (const auto& value : several->array()) {
    tables.push_back(value.table());
    given.push_back(tables.back().require("name", "it names the material as the packing does").string());
    if (std::count(given.begin(), given.end(), given.back()) > 1)
      value.reject(fmt::format("the material '{}' stands twice; keep one", given.back()));
  }
  for (const auto& name : names_) {
    const auto found = std::find(given.begin(), given.end(), name);
    if (found == given.end())
      several->reject(fmt::format("the packing uses the material '{}', which is not among [[materials]]{}",
                                  name, suggestion(name, given)));
    tables_.push_back(tables[static_cast<std::size_t>(found - given.begin())]);
    density_.push_back(tables_.back().positive("density", "kg/m3"));
  }
  if (const auto interfaces = root.find("interfaces"))
    for (const auto& value : interfaces->array()) interfaces_.push_back(value.table());
}

FieldMaterials Materials::field(const std::string& key, TomlTable& field_table,
                                const std::string& capacity_key) {
  FieldMaterials out;
  if (auto boundary = field_table.table("grain_boundary")) out.grain_boundary = read_interface(*boundary);
  if (tables_.empty()) {
    out.of_material.assign(density_.size(), read_conduction(field_table, capacity_key));
    return out;
  }
  for (auto& table : tables_) {
    auto field = table.table(key);
    if (!field)
      throw InputError(fmt::format("{}: '{}' is missing; every material needs its conductivity{}",
                                   table.where(), key, capacity_key.empty() ? "" : " and " + capacity_key));
    out.of_material.push_back(read_conduction(*field, capacity_key));
  }
  for (auto& table : interfaces_) {
    const auto between = table.require("between", "it names two materials").array();
    if (between.size() != 2) table.require("between", "").reject("it must name two materials");
    const auto a = material_index(between[0], names_), b = material_index(between[1], names_);
    if (auto boundary = table.table(key))
      out.between.push_back({{std::min(a, b), std::max(a, b)}, read_interface(*boundary)});
  }
  return out;
}

}  // namespace superstep
