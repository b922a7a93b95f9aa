#include "case/packed/assign_materials.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "case/selection.hpp"

namespace superstep {
namespace {

std::int32_t index_of(const std::string& name, Packing& packing) {
  auto& names = packing.material_names;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] == name) return static_cast<std::int32_t>(k);
  names.push_back(name);
  return static_cast<std::int32_t>(names.size()) - 1;
}

/// Names that nobody has any more are forgotten: every material of a packing must be described.
void drop_unused(Packing& packing) {
  std::vector<std::int32_t> renumbered(packing.material_names.size(), -1);
  std::vector<std::string> names;
  for (auto& material : packing.material) {
    auto& number = renumbered[static_cast<std::size_t>(material)];
    if (number < 0) {
      number = static_cast<std::int32_t>(names.size());
      names.push_back(packing.material_names[static_cast<std::size_t>(material)]);
    }
    material = number;
  }
  packing.material_names = std::move(names);
}

/// A type that all particles have is their material where the case describes one of that name.
void take_single_type(const std::vector<TomlValue>& materials, Packing& packing) {
  if (!packing.material_names.empty() || packing.single_type.empty()) return;
  for (const auto& value : materials) {
    TomlTable table = value.table();
    const auto name = table.find("name");
    if (name && name->is_string() && name->string() == packing.single_type)
      packing.material_names = {packing.single_type};
  }
}

}  // namespace

void assign_materials(TomlTable& root, double unit, Packing& packing) {
  const auto list = root.find("materials");
  if (!list || !list->is_array()) return;
  take_single_type(list->array(), packing);
  const bool named = !packing.material_names.empty();
  std::vector<char> chosen(packing.size(), 0);
  std::optional<TomlValue> last;
  for (const auto& value : list->array()) {
    TomlTable table = value.table();
    const auto where = table.find("where");
    if (!where) continue;
    last = where;
    const std::string name = table.require("name", "it names the material").string();
    const auto selected = select_particles(*where, packing, unit);
    for (std::size_t k = 0; k < packing.size(); ++k) {
      if (!selected[k]) continue;
      if (chosen[k])
        where->reject(fmt::format(
            "particle {} is already in an earlier selection; selections must not overlap", packing.id[k]));
      chosen[k] = 1;
      packing.material[k] = index_of(name, packing);
    }
  }
  if (!last) return;
  for (std::size_t k = 0; k < packing.size() && !named; ++k)
    if (!chosen[k])
      last->reject(
          fmt::format("particle {} is in the selection of no material, and the packing names none; widen a "
                      "selection",
                      packing.id[k]));
  drop_unused(packing);
}

}  // namespace superstep
