#include "audit/oracle/graph_parts.hpp"

#include "core/index.hpp"

namespace superstep::audit {

std::vector<std::int32_t> parts_of_nodes(const Graph& graph, std::int32_t& count) {
  std::vector<std::int32_t> part(graph.nodes(), -1);
  count = 0;
  for (std::size_t seed = 0; seed < graph.nodes(); ++seed) {
    if (graph.is_fixed[seed] || part[seed] >= 0) continue;
    part[seed] = count;
    for (bool grown = true; grown;) {
      grown = false;
      for (std::size_t e = 0; e < graph.edges(); ++e) {
        const auto i = at(graph.i[e]), j = at(graph.j[e]);
        if (!(graph.conductance[e] > 0) || graph.is_fixed[i] || graph.is_fixed[j]) continue;
        if ((part[i] == count) == (part[j] == count)) continue;
        part[i] = part[j] = count;
        grown = true;
      }
    }
    ++count;
  }
  return part;
}

}  // namespace superstep::audit
