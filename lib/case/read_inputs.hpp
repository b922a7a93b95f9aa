#pragma once
/// What acts on a field from outside: `fixed`, `source`, `convection` and `radiation` of its table.

#include "core/text/toml.hpp"
#include "network/graph.hpp"
#include "packing/packing.hpp"

namespace superstep {

/// A number, or a table of time that the graph keeps.
struct Amount {
  double value = 0;         ///< at t = 0
  std::int32_t table = -1;  ///< index into the graph's tables
};

/// Reads a number or `{ times, values }`; a table goes into the graph. Throws InputError.
[[nodiscard]] Amount read_amount(const TomlValue& amount, Graph& graph);

/// Reads the lists into the graph, whose nodes are the particles.
///   unit     [m] of the lengths in selections
///   thermal  convection and radiation are for the temperature alone
/// Throws InputError.
void read_inputs(TomlTable& table, const Packing& packing, double unit, bool thermal, Graph& graph);

}  // namespace superstep
