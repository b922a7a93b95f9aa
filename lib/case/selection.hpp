#pragma once
/// Selections of particles (`where = ...`) in a case file.

#include <map>
#include <string>
#include <vector>

#include "core/text/toml.hpp"
#include "packing/packing.hpp"

namespace superstep {

inline constexpr const char* selects_nobody = "it selects no particle; widen it, or check length_unit";

/// Selections by their place in the case, and whether they held anybody: of a packing that is read part by
/// part, where they must hold somebody somewhere.
using SelectionLog = std::map<std::string, bool>;

/// Mask [particles] of a selection; lengths in the case are `unit` metres each. Throws InputError for an
/// unknown form, an unknown id, or a selection that holds nobody; with a log that is noted there instead.
///   "all" | "top" | "bottom" | { ids = [...] } | { box = { min, max } } | { layer = { side, thickness } }
///   | { sphere = { centre, radius } } | { cylinder = { base, axis, radius, height } }
[[nodiscard]] std::vector<char> select_particles(const TomlValue& where, const Packing& packing, double unit,
                                                 SelectionLog* log = nullptr);

}  // namespace superstep
