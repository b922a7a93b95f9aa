#include "support/sample_graphs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "core/random.hpp"

namespace superstep::test {

Graph random_graph(const RandomGraph& settings) {
  Random random(settings.seed);
  Graph graph = equal_nodes(settings.nodes);
  const auto conductance = [&] { return std::pow(settings.contrast, random.uniform()); };
  std::set<std::pair<std::size_t, std::size_t>> taken;
  const auto join = [&](std::size_t a, std::size_t b) {
    if (a != b && taken.insert(std::minmax(a, b)).second) add_edge(graph, a, b, conductance());
  };
  for (std::size_t k = 1; k < settings.nodes; ++k) join(k, random.bits() % k);
  for (std::size_t k = 0; k < 2 * settings.nodes; ++k)
    join(random.bits() % settings.nodes, random.bits() % settings.nodes);
  for (std::size_t k = 0; k < settings.nodes; ++k) {
    graph.capacity[k] = 1 + random.uniform();
    graph.initial[k] = random.uniform();
    if (settings.sources && k % 3 == 0) graph.source[k] = random.uniform();
  }
  for (std::size_t k = 0; k < settings.fixed; ++k) {
    graph.is_fixed[k * settings.nodes / settings.fixed] = 1;
    graph.fixed_value[k * settings.nodes / settings.fixed] = k % 2 == 0 ? 0.0 : 1.0;
  }
  return graph;
}

Graph chain(std::size_t nodes, std::optional<double> left, std::optional<double> right) {
  Graph graph = equal_nodes(nodes);
  for (std::size_t k = 0; k + 1 < nodes; ++k) add_edge(graph, k, k + 1, 1.0);
  const auto fix = [&](std::size_t node, std::optional<double> value) {
    if (!value) return;
    graph.is_fixed[node] = 1;
    graph.fixed_value[node] = *value;
  };
  fix(0, left);
  fix(nodes - 1, right);
  return graph;
}

Graph star(std::size_t leaves) {
  Graph graph = equal_nodes(leaves + 1);
  graph.initial[0] = 1;
  for (std::size_t k = 1; k <= leaves; ++k) add_edge(graph, 0, k, 1.0);
  return graph;
}

Graph relabelled(const Graph& graph, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::size_t> old(graph.nodes()), now(graph.nodes());
  std::iota(old.begin(), old.end(), std::size_t{0});
  for (std::size_t k = old.size(); k > 1; --k) std::swap(old[k - 1], old[random.bits() % k]);
  Graph out = equal_nodes(graph.nodes());
  for (std::size_t k = 0; k < old.size(); ++k) {
    now[old[k]] = k;
    out.id[k] = graph.id[old[k]];
    out.capacity[k] = graph.capacity[old[k]];
    out.source[k] = graph.source[old[k]];
    out.initial[k] = graph.initial[old[k]];
    out.fixed_value[k] = graph.fixed_value[old[k]];
    out.is_fixed[k] = graph.is_fixed[old[k]];
  }
  for (std::size_t k = graph.edges(); k-- > 0;)
    add_edge(out, now[static_cast<std::size_t>(graph.i[k])], now[static_cast<std::size_t>(graph.j[k])],
             graph.conductance[k]);
  return out;
}

std::vector<NodeRole> plain_roles(const Graph& graph) {
  std::vector<NodeRole> roles;
  for (const char fixed : graph.is_fixed) roles.push_back(fixed ? NodeRole::fixed : NodeRole::free);
  return roles;
}

}  // namespace superstep::test
