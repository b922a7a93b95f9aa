#include "bench/lab/networks.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/random.hpp"

namespace superstep {
namespace {

void fix(Graph& graph, std::size_t node, double value) {
  graph.is_fixed[node] = 1;
  graph.fixed_value[node] = value;
}

LaboratoryNetwork assemble(Graph graph) {
  LaboratoryNetwork out;
  std::vector<NodeRole> roles;
  for (const char fixed : graph.is_fixed) roles.push_back(fixed ? NodeRole::fixed : NodeRole::free);
  Network network = build_network(graph, roles);
  for (const auto node : network.node_of_row)
    out.initial.push_back(graph.initial[static_cast<std::size_t>(node)]);
  const double pair_step = min_pair_step(graph, roles, graph.conductance);
  out.rhs = std::make_unique<NetworkRhs>(std::move(network), "temperature", "K", pair_step);
  out.graph = std::move(graph);
  return out;
}

std::vector<double> random_radii(const RandomNetwork& settings, Random& random) {
  std::vector<double> radii(settings.nodes);
  for (double& radius : radii) radius = std::pow(settings.size_ratio, random.uniform());
  radii[settings.nodes / 3] = 1;
  radii[2 * settings.nodes / 3] = settings.size_ratio;
  return radii;
}

}  // namespace

LaboratoryNetwork chain_network(std::size_t free_nodes) {
  Random random(7);
  Graph graph = equal_nodes(free_nodes + 2);
  for (std::size_t k = 0; k <= free_nodes; ++k) add_edge(graph, k, k + 1, 1.0);
  for (double& value : graph.initial) value = random.uniform();
  fix(graph, 0, 0.0);
  fix(graph, free_nodes + 1, 1.0);
  return assemble(std::move(graph));
}

LaboratoryNetwork random_network(const RandomNetwork& settings) {
  Random random(settings.seed);
  const std::size_t n = settings.nodes;
  Graph graph = equal_nodes(n);
  const auto radii = random_radii(settings, random);
  std::set<std::pair<std::size_t, std::size_t>> taken;
  const auto touch = [&](std::size_t i, std::size_t j) {
    if (i == j || !taken.insert(std::minmax(i, j)).second) return;
    add_edge(graph, i, j, std::min(radii[i], radii[j]) * std::pow(settings.contrast, random.uniform()));
  };
  for (std::size_t k = 1; k < n; ++k) touch(k, random.bits() % k);  // a tree: connected
  for (std::size_t k = 0; k < 2 * n; ++k) {
    const std::size_t i = random.bits() % n, j = random.bits() % n;
    touch(i, j);
  }
  for (std::size_t k = 0; k < n; ++k) {
    graph.capacity[k] = radii[k] * radii[k] * radii[k];
    graph.initial[k] = random.bits() % 2 == 0 ? 0.0 : 1.0;
  }
  fix(graph, 0, 0.0);
  fix(graph, n / 2, 1.0);
  return assemble(std::move(graph));
}

}  // namespace superstep
