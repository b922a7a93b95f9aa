/// A ring with shortcuts across it. Source: Watts & Strogatz (1998), doi:10.1038/30918, with shortcuts added
/// instead of rewired.

#include <algorithm>
#include <utility>

#include "network/generators/exact.hpp"
#include "network/generators/grid.hpp"

namespace superstep {
namespace {

GeneratedNetwork make(const NetworkRecipe& recipe) {
  const std::size_t n = recipe.size;
  GeneratedNetwork network{.graph = equal_nodes(n), .inlet = {0}, .outlet = {}, .heated = {}};
  network.outlet = {static_cast<std::int32_t>(n / 2)};
  Random random(recipe.seed);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t k = 0; k + 1 < n; ++k) pairs.emplace_back(k, k + 1);
  pairs.emplace_back(0, n - 1);
  const auto shortcuts = static_cast<std::size_t>(recipe.fraction * static_cast<double>(n));
  for (std::size_t k = 0; k < shortcuts; ++k) {
    const std::size_t a = random.below(n), b = random.below(n);
    if (a != b) pairs.emplace_back(std::min(a, b), std::max(a, b));
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  for (const auto& [a, b] : pairs) add_edge(network.graph, a, b, spread_value(random, recipe.contrast));
  for (double& capacity : network.graph.capacity) capacity = spread_value(random, recipe.spread);
  heat_some(network);
  return network;
}

}  // namespace

NetworkGenerator rings_generator() {
  return {.name = "rings",
          .makes = "a ring with random shortcuts; inlet and outlet lie opposite",
          .fraction = "shortcuts a node",
          .make = make};
}

}  // namespace superstep
