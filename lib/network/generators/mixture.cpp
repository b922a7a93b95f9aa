/// A porous electrode: grains of three phases, of which one conducts well, one poorly and one in between.

#include <cmath>

#include "network/generators/exact.hpp"
#include "network/generators/grid.hpp"

namespace superstep {
namespace {

GeneratedNetwork make(const NetworkRecipe& recipe) {
  const Grid grid = Grid::of(recipe.size);
  GeneratedNetwork network = nodes_of(grid);
  Random random(recipe.seed);
  const double middle = std::sqrt(recipe.contrast);
  std::vector<double> conductivity(grid.cells());
  for (std::size_t k = 0; k < grid.cells(); ++k) {
    const bool good = random.uniform() < recipe.fraction, poor = random.uniform() < 0.5;
    conductivity[k] = good ? recipe.contrast : poor ? 1 : middle;
    network.graph.capacity[k] = good ? 1 : poor ? recipe.spread : std::sqrt(recipe.spread);
  }
  grid.for_faces([&](std::size_t a, std::size_t b) {  // halves in series
    const double ka = conductivity[a], kb = conductivity[b];
    add_edge(network.graph, a, b, 2 / (1 / ka + 1 / kb));
  });
  return network;
}

}  // namespace

NetworkGenerator mixture_generator() {
  return {.name = "mixture",
          .makes = "a cube of grains of three phases: good, poor, and half-way between (in logarithms)",
          .fraction = "grains that conduct well; the others are divided evenly",
          .make = make};
}

}  // namespace superstep
