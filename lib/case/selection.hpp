#pragma once
/// Selections of particles (`where = ...`) in a case file.

#include <vector>

#include "core/text/toml.hpp"
#include "packing/packing.hpp"

namespace superstep {

inline constexpr const char* selects_nobody = "it selects no particle; widen it, or check length_unit";

/// Mask [particles] of a selection; lengths in the case are `unit` metres each. Throws InputError for an
/// unknown form, an unknown id, or a selection that holds nobody; of a part of a packing it is noted in the
/// part who holds somebody.
///   "all" | "top" | "bottom" | { ids = [...] } | { box = { min, max } } | { layer = { side, thickness } }
///   | { sphere = { centre, radius } } | { cylinder = { base, axis, radius, height } }
[[nodiscard]] std::vector<char> select_particles(const TomlValue& where, const Packing& packing, double unit);

}  // namespace superstep
