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
/// Returns warnings of what can do nothing; of a packing that is read part by part, `input.fed` notes it.
/// Throws InputError.
[[nodiscard]] std::vector<std::string> read_inputs(TomlTable& table, const PackingInput& input, bool thermal,
                                                   Graph& graph);
/// The warning about what stands at a place of the case and feeds fixed particles alone.
[[nodiscard]] std::string feeds_nobody(const std::string& place);

}  // namespace superstep
