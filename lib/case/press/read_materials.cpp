#include "case/press/read_materials.hpp"

#include <fmt/format.h>

#include <utility>

#include "case/press/read_values.hpp"

namespace superstep::dynamics {
namespace {

PressMaterial read_one(TomlTable table, bool electric) {
  PressMaterial one;
  const auto name = table.require("name", "it names the material as particles do");
  one.name = name.string();
  if (one.name.empty()) name.reject("it must not be empty");
  one.density = table.positive("density", "kg/m3");
  TomlTable thermal = table_from(table, "thermal", "its conductivity and specific_heat");
  one.conductivity = required_from(thermal, "conductivity", 0, "W/(m K)");
  one.specific_heat = thermal.positive("specific_heat", "J/(kg K)");
  if (electric) {
    TomlTable own = table_from(table, "electric", "its conductivity");
    one.electric_conductivity = own.positive("conductivity", "S/m");
  } else if (const auto other = table.find("electric")) {
    other->reject("the case has no [electric]; remove it");
  }
  one.hardness = positive_or(table, "hardness", 1, "-");
  one.share = number_from(table, "share", 0, 0, "-");
  table.finish();
  return one;
}

}  // namespace

std::vector<PressMaterial> read_press_materials(TomlTable& root, bool electric) {
  const auto several = root.find("materials");
  if (!several) {
    TomlTable material = table_from(root, "material", "it holds the density");
    PressMaterial one;
    one.density = material.positive("density", "kg/m3");
    return {one};
  }
  if (root.find("material")) several->reject("give either [material] or [[materials]], not both");
  std::vector<PressMaterial> out;
  for (const auto& entry : several->array()) {
    out.push_back(read_one(entry.table(), electric));
    for (std::size_t k = 0; k + 1 < out.size(); ++k)
      if (out[k].name == out.back().name)
        entry.reject(fmt::format("there is a material '{}' already; name each once", out.back().name));
  }
  if (out.empty()) several->reject("there must be at least one material");
  for (const auto& [field, key] :
       {std::pair{"thermal", "conductivity"}, {"thermal", "specific_heat"}, {"electric", "conductivity"}})
    if (auto table = root.table(field))
      if (const auto value = table->find(key))
        value->reject("each of [[materials]] has its own; remove it here");
  return out;
}

}  // namespace superstep::dynamics
