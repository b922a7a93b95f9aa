#pragma once
/// Small networks.

#include <cstdint>
#include <optional>
#include <vector>

#include "network/graph.hpp"
#include "network/network.hpp"

namespace superstep::test {

/// A random connected network: a spanning tree plus extra edges; capacities in [1, 2], conductances in [1,
/// contrast].
struct RandomGraph {
  std::size_t nodes = 30;
  std::uint64_t seed = 1;
  double contrast = 10;
  std::size_t fixed = 2;  ///< nodes held at 0 and 1 in turn
  bool sources = false;
};
[[nodiscard]] Graph random_graph(const RandomGraph& settings);

/// n equal nodes in a row, conductance and capacity 1; the ends may be fixed at the given values.
[[nodiscard]] Graph chain(std::size_t nodes, std::optional<double> left = {},
                          std::optional<double> right = {});
/// One hub (node 0) with `leaves` leaves, conductance and capacity 1, hub at 1 and leaves at 0.
[[nodiscard]] Graph star(std::size_t leaves);
/// The same graph with its nodes in a random order and its ids kept with their nodes.
[[nodiscard]] Graph relabelled(const Graph& graph, std::uint64_t seed);

/// Roles without any skipping: fixed nodes fixed, all others free.
[[nodiscard]] std::vector<NodeRole> plain_roles(const Graph& graph);

}  // namespace superstep::test
