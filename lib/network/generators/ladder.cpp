/// Resistors in a row, a capacitor behind each: a rod that gets thinner, a cable, a discharging line.

#include "network/generators/exact.hpp"
#include "network/generators/grid.hpp"

namespace superstep {
namespace {

// inlet o-K1-o-K2-o- ... -o outlet, conductances falling from `contrast` to 1, capacities rising from 1.
GeneratedNetwork make(const NetworkRecipe& recipe) {
  const std::size_t n = recipe.size;
  GeneratedNetwork network{.graph = equal_nodes(n), .inlet = {0}, .outlet = {}, .heated = {}};
  network.outlet = {static_cast<std::int32_t>(n - 1)};
  const double last = static_cast<double>(n - 1);
  for (std::size_t k = 0; k < n; ++k)
    network.graph.capacity[k] = power(recipe.spread, static_cast<double>(k) / last);
  for (std::size_t k = 0; k + 1 < n; ++k)
    add_edge(network.graph, k, k + 1,
             power(recipe.contrast, 1 - static_cast<double>(k) / (last > 1 ? last - 1 : 1)));
  heat_some(network);
  return network;
}

}  // namespace

NetworkGenerator ladder_generator() {
  return {.name = "ladder",
          .makes = "resistors and capacitors in a row, graded from the inlet to the outlet",
          .fraction = "",
          .make = make};
}

}  // namespace superstep
