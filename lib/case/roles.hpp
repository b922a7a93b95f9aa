#pragma once
/// Which nodes are integrated, which are known, and which can be left alone.

#include <span>
#include <vector>

#include "core/error.hpp"
#include "network/eliminate.hpp"
#include "network/graph.hpp"
#include "network/network.hpp"

namespace superstep {

struct RoleReport {
  std::vector<NodeRole> roles;  ///< [nodes]
  std::vector<char> live;      ///< [nodes] 1 where the node's component is not idle: something may flow there
  std::size_t components = 0;  ///< of the graph as stated, before nodes of capacity 0 were eliminated
  std::size_t idle_clusters = 0;  ///< components in which nothing can change
  std::size_t floating = 0;       ///< components without a fixed node that are integrated
  std::size_t adrift = 0;         ///< those of them that exchange nothing with an ambient
};

struct NothingFree : InputError {
  using InputError::InputError;
};

/// A component is idle when all its initial and fixed values are equal and nothing acts on it: no source, no
/// ambient of another value, nothing that changes in time. When that would leave nothing to integrate, idle
/// components are integrated all the same.
///   acted_on   [nodes] or empty: nodes that something outside the graph acts on
///   algebraic  eliminated nodes: they join what they touched, are idle, and where they start says nothing
/// Throws NothingFree (beginning with `where`) when every node is fixed.
[[nodiscard]] RoleReport assign_roles(const Graph& graph, const std::string& where,
                                      std::span<const char> acted_on = {},
                                      std::span<const AlgebraicNode> algebraic = {});

/// Roles for a steady solve: a component without a fixed node has no steady state of its own and is left out;
/// floating counts those. Live are components in which a current flows. Throws InputError when a source feeds
/// a component without a fixed node, or when fixed values differ and yet no component holds two of them.
[[nodiscard]] RoleReport assign_steady_roles(const Graph& graph, const std::string& where);

}  // namespace superstep
