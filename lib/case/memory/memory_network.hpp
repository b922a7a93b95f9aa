#pragma once
/// A network in memory: nodes and edges out of arrays.

#include <string>

#include "case/memory/case_data.hpp"
#include "network/files/read_network.hpp"

namespace superstep {

/// Nodes 0, 1, ... of capacity 1, or of what the arrays say, and their edges.
///   kind, ambient  of a matrix, see read_matrix_network
/// Throws InputError that begins with `name`.
[[nodiscard]] NetworkInput network_of(const NetworkArrays& arrays, const std::string& name, MatrixKind kind,
                                      double ambient);

}  // namespace superstep
