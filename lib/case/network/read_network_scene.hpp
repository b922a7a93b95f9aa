#pragma once
/// `[network]`: nodes and edges given directly, as files or by a generator.

#include "case/scene.hpp"
#include "core/text/toml.hpp"

namespace superstep {

struct NetworkArrays;

/// What `[network]` says of its field besides nodes and edges. Throws InputError.
[[nodiscard]] FieldScene describe_network_field(TomlTable& network);

/// Adds the one field of such a scene. Throws InputError.
///   arrays  nodes and edges in memory, instead of files or a generator; null = there are none
void read_network_scene(TomlTable& root, TomlTable& network, Scene& scene,
                        const NetworkArrays* arrays = nullptr);

}  // namespace superstep
