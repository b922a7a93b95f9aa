/// A binary tree: vessels, roots, a distribution grid. Branches get weaker from the trunk to the tips.

#include "network/generators/exact.hpp"
#include "network/generators/grid.hpp"

namespace superstep {
namespace {

GeneratedNetwork make(const NetworkRecipe& recipe) {
  const std::size_t n = recipe.size;
  GeneratedNetwork network{.graph = equal_nodes(n), .inlet = {0}, .outlet = {}, .heated = {}};
  std::size_t deepest = 0;
  for (std::size_t k = n; k > 1; k /= 2) ++deepest;
  Random random(recipe.seed);
  const auto part_of = [&](std::size_t node) {  // of the way down, 0 at the trunk
    std::size_t level = 0;
    for (std::size_t k = node + 1; k > 1; k /= 2) ++level;
    return static_cast<double>(level) / static_cast<double>(deepest);
  };
  for (std::size_t k = 0; k < n; ++k) network.graph.capacity[k] = power(recipe.spread, 1 - part_of(k));
  for (std::size_t k = 1; k < n; ++k)  // branches of one level differ by up to a factor of two
    add_edge(network.graph, (k - 1) / 2, k,
             power(recipe.contrast, 1 - part_of(k)) * spread_value(random, recipe.contrast > 1 ? 2 : 1));
  for (std::size_t k = n / 2; k < n; ++k) network.outlet.push_back(static_cast<std::int32_t>(k));
  heat_some(network);
  return network;
}

}  // namespace

NetworkGenerator tree_generator() {
  return {.name = "tree",
          .makes = "a binary tree whose branches get weaker; the inlet is the trunk, the outlet are the tips",
          .fraction = "",
          .make = make};
}

}  // namespace superstep
