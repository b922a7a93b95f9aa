#include "network/graph.hpp"

#include <algorithm>

namespace superstep {

Graph equal_nodes(std::size_t n) {
  Graph graph;
  for (std::size_t k = 0; k < n; ++k) graph.id.push_back(static_cast<std::int64_t>(k));
  graph.capacity.assign(n, 1.0);
  graph.source.assign(n, 0.0);
  graph.initial.assign(n, 0.0);
  graph.fixed_value.assign(n, 0.0);
  graph.is_fixed.assign(n, 0);
  return graph;
}

void add_edge(Graph& graph, std::size_t i, std::size_t j, double conductance) {
  graph.i.push_back(static_cast<std::int32_t>(std::min(i, j)));
  graph.j.push_back(static_cast<std::int32_t>(std::max(i, j)));
  graph.conductance.push_back(conductance);
}

}  // namespace superstep
