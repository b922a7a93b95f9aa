#pragma once
/// What acts on a field from outside: `fixed`, `source`, `convection` and `radiation` of its table.

#include "core/text/toml.hpp"
#include "network/graph.hpp"
#include "packing/packing.hpp"

namespace superstep {

/// Reads the lists into the graph, whose nodes are the particles.
///   unit     [m] of the lengths in selections
///   thermal  convection and radiation are for the temperature alone
/// Throws InputError.
void read_inputs(TomlTable& table, const Packing& packing, double unit, bool thermal, Graph& graph);

}  // namespace superstep
