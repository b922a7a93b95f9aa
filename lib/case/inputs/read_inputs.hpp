#pragma once
/// What acts on a field from outside: `fixed`, `source`, `convection` and `radiation` of its table.

#include <string>
#include <vector>

#include "case/read_packing_scene.hpp"
#include "core/text/toml.hpp"
#include "network/graph.hpp"

namespace superstep {

/// Reads the lists into the graph, whose nodes are the particles.
///   thermal  convection and radiation are for the temperature alone
/// Returns warnings of what can do nothing. Throws InputError.
[[nodiscard]] std::vector<std::string> read_inputs(TomlTable& table, const PackingInput& input, bool thermal,
                                                   Graph& graph);

}  // namespace superstep
