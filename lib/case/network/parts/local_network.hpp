#pragma once
/// Own nodes of a network, and those of others at the other ends of their edges, as a graph.

#include <cstdint>
#include <vector>

#include "case/network/parts/shared_edges.hpp"
#include "case/network/parts/shared_nodes.hpp"
#include "network/part.hpp"

namespace superstep {

/// One node more, which has no edges yet.
void add_node(const SharedNode& node, Graph& graph);

/// Nodes stand in the order of their numbers.
class LocalNetwork {
 public:
  /// Collective.
  ///   edges  all that end at own nodes
  LocalNetwork(const SharedNodes& nodes, const std::vector<SharedEdge>& edges, Communicator& among);

  [[nodiscard]] const Graph& graph() const noexcept { return graph_; }
  /// The number of a node of the graph among all.
  [[nodiscard]] std::int64_t number(std::size_t node) const noexcept;
  /// Of its edges [s].
  [[nodiscard]] double pair_step() const;
  /// Of own rows, counted from the origin.
  [[nodiscard]] std::vector<double> initial(double origin) const;
  /// Own rows.
  [[nodiscard]] NetworkPart part(double origin) &&;

 private:
  IndexRange here_;                   // numbers of own nodes
  std::vector<std::int64_t> beyond_;  // numbers of the others, ascending
  std::size_t below_ = 0;             // of them, as many before the own ones
  Graph graph_;
  std::vector<NodeRole> roles_;
  std::vector<std::int64_t> row_;  // of all, by nodes of the graph
};

}  // namespace superstep
