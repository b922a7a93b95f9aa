/// Pores on a cube and the throats between them: throats as narrow as the smaller pore allows, conducting as
/// the fourth power of that.

#include <algorithm>
#include <cmath>

#include "network/generators/exact.hpp"
#include "network/generators/grid.hpp"

namespace superstep {
namespace {

GeneratedNetwork make(const NetworkRecipe& recipe) {
  const Grid grid = Grid::of(recipe.size);
  GeneratedNetwork network = nodes_of(grid);
  Random random(recipe.seed);
  // A pore and the narrowing of a throat have half of the contrast each.
  const double half = std::sqrt(recipe.contrast), ratio = std::sqrt(std::sqrt(half));
  const double volumes = cube_root(recipe.spread);
  std::vector<double> radius(grid.cells());
  for (std::size_t k = 0; k < grid.cells(); ++k) {
    const double part = random.uniform(), size = power(volumes, part);
    radius[k] = power(ratio, part);
    network.graph.capacity[k] = size * size * size;
  }
  grid.for_faces([&](std::size_t a, std::size_t b) {
    const bool open = random.uniform() >= recipe.fraction;
    const double pore = std::min(radius[a], radius[b]), throat = spread_value(random, half);
    if (open) add_edge(network.graph, a, b, pore * pore * pore * pore * throat);
  });
  return network;
}

}  // namespace

NetworkGenerator pores_generator() {
  return {.name = "pores",
          .makes = "pores on a cube with throats of the fourth power of their width between them",
          .fraction = "throats that are closed",
          .make = make};
}

}  // namespace superstep
