#pragma once
/// Nodes without a capacity: their values follow from their neighbours at every instant, so that they are
/// eliminated.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "network/graph.hpp"

namespace superstep {

/// How the value of an eliminated node follows: sum of weight * value of other nodes, plus a constant, plus
/// factor * table(t).
struct AlgebraicNode {
  std::int32_t node = 0;
  std::vector<std::pair<std::int32_t, double>>
      weight;  ///< nodes that are no algebraic ones, or were eliminated later
  double constant = 0;
  std::vector<std::pair<std::int32_t, double>> tabled;  ///< index into the graph's tables, factor
};

/// Eliminates every free node of capacity 0 exactly (a star of conductances becomes a mesh: the Schur
/// complement of a Laplacian is one). The nodes stay in the graph, alone, with capacity 1 and their initial
/// value; the list says in which order they were eliminated, and their values are found by walking it
/// backwards. Throws InputError (beginning with `where`) for a node that nothing determines, one that
/// radiates, and a graph in which nothing is left.
[[nodiscard]] std::vector<AlgebraicNode> eliminate_algebraic_nodes(Graph& graph, const std::string& where);

/// Fills in the values of algebraic nodes among those of all nodes.
void recover_algebraic_values(const std::vector<AlgebraicNode>& nodes, const Graph& graph, double t,
                              std::vector<double>& value);

}  // namespace superstep
