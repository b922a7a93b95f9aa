#pragma once
/// `[network]` out of files.

#include "core/text/toml.hpp"
#include "network/files/read_network.hpp"

namespace superstep {

/// Reads `nodes` and `edges`, `edges` alone, `matrix`, or `openpnm`, with what goes with them.
///   t_end [s]  how far repeated profiles are written out
/// Throws InputError.
[[nodiscard]] NetworkInput read_network_files(TomlTable& network, double t_end);

}  // namespace superstep
