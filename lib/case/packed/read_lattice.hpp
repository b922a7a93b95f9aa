#pragma once
/// `[packing] generator = "lattice"`: equal spheres on a simple cubic lattice.

#include "core/text/toml.hpp"
#include "packing/lattice.hpp"

namespace superstep {

/// Reads `cells`, `spacing` and `diameter`; lengths are `unit` metres each. Throws InputError, for a misspelt
/// key first.
[[nodiscard]] Lattice read_lattice(TomlTable& packing, double unit);

}  // namespace superstep
