#pragma once
/// Edges of a network that several processes share: each reads a part of their file, and then has those that
/// end at its nodes.

#include <cstdint>
#include <vector>

#include "case/network/parts/node_directory.hpp"

namespace superstep {

struct SharedEdge {
  std::int64_t i = 0, j = 0;  ///< nodes, i < j; ids while it is read
  double conductance = 0;
  std::uint64_t number = 0;  ///< ascends with the rows of the file
};

struct SharedEdges {
  std::vector<SharedEdge> own;  ///< in the order of the file
  std::uint64_t count = 0;      ///< of the whole network
  std::uint64_t joined = 0;     ///< that ran parallel to one of these
};

/// Collective. Edges that run parallel are joined. Throws InputError, on all processes the same.
[[nodiscard]] SharedEdges share_edges(const RowsInParts& table, const SharedNodes& nodes,
                                      const NodeDirectory& directory, Communicator& among);

}  // namespace superstep
