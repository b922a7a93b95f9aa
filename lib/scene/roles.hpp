#pragma once
/// Which nodes are integrated, which are known, and which can be left alone.

#include <vector>

#include "network/graph.hpp"
#include "network/network.hpp"

namespace superstep {

struct RoleReport {
  std::vector<NodeRole> roles;    ///< [nodes]
  std::size_t components = 0;     ///< of the whole graph
  std::size_t idle_clusters = 0;  ///< components in which nothing can change
  std::size_t floating = 0;       ///< components without a fixed node that are integrated
};

/// A component is idle when all its initial and fixed values are equal and nothing acts on it. When that
/// would leave nothing to integrate, idle components are integrated all the same. Throws InputError
/// (beginning with `where`) when every node is fixed.
[[nodiscard]] RoleReport assign_roles(const Graph& graph, const std::string& where);

}  // namespace superstep
