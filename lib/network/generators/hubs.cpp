/// A few nodes with very many neighbours. Source: Barabasi & Albert (1999), doi:10.1126/science.286.5439.509.

#include <algorithm>

#include "network/generators/exact.hpp"
#include "network/generators/grid.hpp"

namespace superstep {
namespace {

// Every new node takes two older ones, each as likely as it has neighbours.
GeneratedNetwork make(const NetworkRecipe& recipe) {
  const std::size_t n = recipe.size;
  GeneratedNetwork network{.graph = equal_nodes(n), .inlet = {0}, .outlet = {}, .heated = {}};
  Random random(recipe.seed);
  std::vector<std::size_t> ends = {0, 1};  // every node as often as it has neighbours
  add_edge(network.graph, 0, 1, spread_value(random, recipe.contrast));
  for (std::size_t k = 2; k < n; ++k) {
    const std::size_t a = ends[random.below(ends.size())];
    std::size_t b = a;
    while (b == a) b = ends[random.below(ends.size())];
    for (const std::size_t other : {std::min(a, b), std::max(a, b)}) {
      add_edge(network.graph, other, k, spread_value(random, recipe.contrast));
      ends.push_back(other);
      ends.push_back(k);
    }
  }
  for (double& capacity : network.graph.capacity) capacity = spread_value(random, recipe.spread);
  for (std::size_t k = n - n / 10 - 1; k < n; ++k) network.outlet.push_back(static_cast<std::int32_t>(k));
  heat_some(network);
  return network;
}

}  // namespace

NetworkGenerator hubs_generator() {
  return {.name = "hubs",
          .makes = "a scale-free network; the inlet is its oldest node, the outlet is its youngest tenth",
          .fraction = "",
          .make = make};
}

}  // namespace superstep
