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

/// The fields that a material or an interface may describe, with the keys of their capacities. A case need
/// not have them all: a material may say more than this case asks.
constexpr std::pair<const char*, const char*> fields[] = {{"thermal", "specific_heat"},
                                                          {"electric", "specific_capacity"}};

void check_fields(TomlTable& table) {
  for (const auto& [key, capacity_key] : fields) {
    auto field = table.table(key);
    if (!field) continue;
    (void)read_conduction(*field, field->find(capacity_key) ? capacity_key : "");
  }
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
    if (!one) root.missing("material", "[material] is missing; give at least its density [kg/m3]");
    if (const auto interfaces = root.find("interfaces"))
      interfaces->reject("interfaces lie between two of [[materials]], and there is one [material]");
    density_.assign(std::max<std::size_t>(1, packing.material_names.size()),
                    one->positive("density", "kg/m3"));
    return;
  }
  if (root.find("material")) several->reject("give either [material] or [[materials]], not both");
  if (packing.material_names.empty())
    several->reject("the packing has no material column; add one, or give a single [material]");
  read_materials(*several, packing);
  if (const auto interfaces = root.find("interfaces")) read_interfaces(*interfaces);
}

void Materials::read_materials(const TomlValue& list, const Packing& packing) {
  std::vector<std::string> names;
  std::vector<double> densities;
  for (const auto& value : list.array()) {
    TomlTable table = value.table();
    const auto name = table.require("name", "it names the material as the packing does");
    if (std::find(names.begin(), names.end(), name.string()) != names.end())
      value.reject(fmt::format("the material '{}' stands twice; keep one", name.string()));
    names.push_back(name.string());
    densities.push_back(table.positive("density", "kg/m3"));
    check_fields(table);
    given_.push_back({names.back(), table});
  }
  for (const auto& name : packing.material_names) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      list.reject(fmt::format("the packing uses the material '{}', which is not among [[materials]]{}", name,
                              suggestion(name, names)));
    used_.push_back(static_cast<std::size_t>(found - names.begin()));
    density_.push_back(densities[used_.back()]);
  }
}

void Materials::read_interfaces(const TomlValue& list) {
  std::vector<std::string> names;
  for (const auto& one : given_) names.push_back(one.name);
  const auto index = [&](const TomlValue& name) {
    const auto found = std::find(names.begin(), names.end(), name.string());
    if (found == names.end())
      name.reject("it must be the name of one of [[materials]]" + suggestion(name.string(), names));
    return static_cast<std::int32_t>(found - names.begin());
  };
  for (const auto& value : list.array()) {
    TomlTable table = value.table();
    const auto between = table.require("between", "it names two materials");
    const auto pair = between.array();
    if (pair.size() != 2) between.reject("it must name two materials");
    const auto a = index(pair[0]), b = index(pair[1]);
    add_interface(table, {std::min(a, b), std::max(a, b)});
  }
}

void Materials::add_interface(TomlTable& table, std::pair<std::int32_t, std::int32_t> between) {
  bool says_something = false;
  for (const auto& [key, capacity_key] : fields) {
    auto boundary = table.table(key);
    if (!boundary) continue;
    says_something = true;
    for (const auto& earlier : interfaces_)
      if (earlier.key == key && earlier.between == between)
        throw InputError(
            fmt::format("{}: the {} interface between '{}' and '{}' stands already in {}; keep one",
                        boundary->where(), key, given_[static_cast<std::size_t>(between.first)].name,
                        given_[static_cast<std::size_t>(between.second)].name, earlier.place));
    interfaces_.push_back({key, boundary->where(), between, read_interface(*boundary)});
  }
  if (!says_something)
    table.missing("thermal",
                  "it describes no interface; give thermal or electric = { thickness, reduction }");
}

FieldMaterials Materials::field(const std::string& key, TomlTable& field_table,
                                const std::string& capacity_key) {
  FieldMaterials out;
  if (auto boundary = field_table.table("grain_boundary")) out.grain_boundary = read_interface(*boundary);
  if (given_.empty()) {
    out.of_material.assign(density_.size(), read_conduction(field_table, capacity_key));
    return out;
  }
  for (const std::size_t k : used_) {
    TomlTable& table = given_[k].table;
    auto field = table.table(key);
    if (!field)
      table.missing(key, fmt::format("'{}' is missing; every material needs its conductivity{}", key,
                                     capacity_key.empty() ? "" : " and " + capacity_key));
    out.of_material.push_back(read_conduction(*field, capacity_key));
  }
  const auto position = [&](std::int32_t given) {
    return static_cast<std::int32_t>(std::find(used_.begin(), used_.end(), static_cast<std::size_t>(given)) -
                                     used_.begin());
  };
  for (const auto& one : interfaces_) {
    const auto a = position(one.between.first), b = position(one.between.second);
    const auto materials = static_cast<std::int32_t>(used_.size());
    if (one.key != key || a >= materials || b >= materials) continue;
    out.between.push_back({{std::min(a, b), std::max(a, b)}, one.interface});
    out.place = one.place;
  }
  return out;
}

}  // namespace superstep
