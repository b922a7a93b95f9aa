#pragma once
/// `[network]`: nodes and edges given directly, as files or by a generator.

#include "case/scene.hpp"
#include "core/text/toml.hpp"

namespace superstep {

/// Adds the one field of such a scene. Throws InputError.
void read_network_scene(TomlTable& root, TomlTable& network, Scene& scene);

}  // namespace superstep
