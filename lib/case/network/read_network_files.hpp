#pragma once
/// `[network]` out of files.

#include "core/text/toml.hpp"
#include "network/files/read_network.hpp"

namespace superstep {

struct NetworkArrays;

/// Reads `nodes` and `edges`, `edges` alone, `matrix`, or `openpnm`, with what goes with them.
///   t_end [s]  how far repeated profiles are written out
///   arrays     nodes and edges in memory, instead of files; null = there are none
/// Throws InputError.
[[nodiscard]] NetworkInput read_network_files(TomlTable& network, double t_end, const NetworkArrays* arrays);

}  // namespace superstep
