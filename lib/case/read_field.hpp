#pragma once
/// `[thermal]` and `[electric]` of a case: one field's graph on the particles.

#include <string>

#include "case/materials.hpp"
#include "case/read_packing_scene.hpp"
#include "case/scene.hpp"
#include "core/text/toml.hpp"

namespace superstep {

/// What tells the two fields apart.
struct FieldKind {
  std::string table;         ///< "thermal" | "electric"
  std::string name, unit;    ///< "temperature", "K" | "potential", "V"
  std::string capacity_key;  ///< "specific_heat" | "specific_capacity"
};
[[nodiscard]] const FieldKind& thermal_kind();
[[nodiscard]] const FieldKind& electric_kind();

/// Reads one field's table and builds its graph: capacities, conductances at the laws' reference values,
/// initial and fixed values, sources and what else acts on it. Throws InputError.
///   steady  the field is solved for, so that it has no capacity
[[nodiscard]] FieldScene read_field(const FieldKind& kind, TomlTable& table, const PackingInput& input,
                                    Materials& materials, bool steady);

}  // namespace superstep
