#pragma once
/// Connected components of a scene that nobody has as a whole.

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "case/component_facts.hpp"
#include "core/index.hpp"
#include "network/disjoint_sets.hpp"
#include "network/graph.hpp"
#include "parallel/all_to_all.hpp"

namespace superstep {

class PartClusters {
 public:
  /// Of a process that has nodes [begin, end).
  PartClusters(std::int64_t begin, std::int64_t end);

  /// Takes own nodes out of a graph, and the edges that are theirs: an edge is its first node's.
  ///   nodes    which of them, if they are own ones
  ///   node_of  the number of a position in the graph
  template <class NodeOf>
  void take(const Graph& graph, const IndexRange& nodes, const NodeOf& node_of);
  /// Collective, once all own nodes are there: components of the whole scene without a fixed node that
  /// exchange nothing with an ambient and in which something happens, or all of these where nothing happens
  /// anywhere.
  [[nodiscard]] std::uint64_t count_adrift(Communicator& among) &&;

 private:
  struct Edge {
    std::int64_t i, j;
  };
  struct Cluster {
    std::int64_t root;  // a node
    ComponentFacts facts;
  };
  [[nodiscard]] std::int64_t root_of(std::int64_t node) {
    return begin_ + sets_.root(static_cast<std::uint32_t>(node - begin_));
  }
  void join(std::int64_t i, std::int64_t j);
  [[nodiscard]] std::vector<Edge> name_by_roots(Communicator& among);

  std::int64_t begin_, end_;
  DisjointSets sets_;
  std::vector<ComponentFacts> facts_;  // [own nodes], of the node alone until they are counted
  std::vector<Edge> beyond_;           // to nodes of others
};

template <class NodeOf>
void PartClusters::take(const Graph& graph, const IndexRange& nodes, const NodeOf& node_of) {
  const IndexRange own = nodes.overlap({begin_, end_});
  for (std::size_t k = 0; k < graph.nodes(); ++k)
    if (const std::int64_t node = node_of(k); own.holds(node)) facts_[at(node - begin_)].take_node(graph, k);
  for (const auto* exchanges : {&graph.convection, &graph.radiation})
    for (const auto& exchange : *exchanges)
      if (const std::int64_t node = node_of(at(exchange.node)); own.holds(node))
        facts_[at(node - begin_)].take_exchange(exchange);
  for (std::size_t k = 0; k < graph.edges(); ++k) {
    const std::int64_t a = node_of(at(graph.i[k])), b = node_of(at(graph.j[k]));
    if (own.holds(std::min(a, b)) && graph.conductance[k] > 0) join(std::min(a, b), std::max(a, b));
  }
}

}  // namespace superstep
