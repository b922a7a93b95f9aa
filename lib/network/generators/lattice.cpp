/// A cubic lattice of equal particles whose contacts are not equal.

#include "network/generators/exact.hpp"
#include "network/generators/grid.hpp"

namespace superstep {
namespace {

GeneratedNetwork make(const NetworkRecipe& recipe) {
  const Grid grid = Grid::of(recipe.size);
  GeneratedNetwork network = nodes_of(grid);
  Random random(recipe.seed);
  grid.for_faces([&](std::size_t a, std::size_t b) {
    const bool there = random.uniform() >= recipe.fraction;
    const double conductance = spread_value(random, recipe.contrast);
    if (there) add_edge(network.graph, a, b, conductance);
  });
  for (double& capacity : network.graph.capacity) capacity = spread_value(random, recipe.spread);
  return network;
}

}  // namespace

NetworkGenerator lattice_generator() {
  return {.name = "lattice",
          .makes = "a cube of particles, each in contact with up to six; conductances log-uniform",
          .fraction = "contacts that are missing",
          .make = make};
}

}  // namespace superstep
