#pragma once
/// `[network]` of a case: a graph given directly.

#include "case/scene.hpp"
#include "core/text/toml.hpp"

namespace superstep {

/// Reads `nodes` and `edges`, `matrix`, or `openpnm`, with what goes with them, and eliminates nodes of
/// capacity 0. Adds the field and notes to the scene, which must know its end. Throws InputError.
void read_direct_network(TomlTable& root, TomlTable& network, Scene& scene);

}  // namespace superstep
