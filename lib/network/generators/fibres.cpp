/// Straight fibres along the three axes, conducting well along themselves and poorly where two of them touch.

#include "network/generators/exact.hpp"
#include "network/generators/grid.hpp"

namespace superstep {
namespace {

constexpr std::int32_t nobody = -1;

/// Number of the fibre in each cell.
std::vector<std::int32_t> lay_fibres(const Grid& grid, double part, Random& random) {
  std::vector<std::int32_t> fibre(grid.cells(), nobody);
  const auto wanted = static_cast<std::size_t>(part * static_cast<double>(grid.cells()));
  std::size_t filled = 0;
  // A fibre that finds its way taken in part fills what is left of it; so many trials fill any cube.
  const std::size_t trials = 30 * grid.side * grid.side;
  for (std::size_t k = 0; k < trials && filled < wanted; ++k) {
    const std::size_t axis = random.below(3), u = random.below(grid.side), v = random.below(grid.side);
    for (std::size_t w = 0; w < grid.side; ++w) {
      auto& cell = fibre[axis == 0   ? grid.cell(w, u, v)
                         : axis == 1 ? grid.cell(u, w, v)
                                     : grid.cell(u, v, w)];
      if (cell != nobody) continue;
      cell = static_cast<std::int32_t>(k);
      ++filled;
    }
  }
  return fibre;
}

GeneratedNetwork make(const NetworkRecipe& recipe) {
  // The cube is so large that the part of it that fibres fill has about the size asked for.
  const double part = recipe.fraction > 0 ? recipe.fraction : 1;
  const Grid grid = Grid::of(static_cast<std::size_t>(static_cast<double>(recipe.size) / part));
  Random random(recipe.seed);
  const auto fibre = lay_fibres(grid, part, random);
  std::vector<std::int32_t> node(grid.cells(), nobody);
  GeneratedNetwork network;
  std::int32_t count = 0;
  for (std::size_t k = 0; k < grid.cells(); ++k) {
    if (fibre[k] == nobody) continue;
    node[k] = count++;
    if (grid.layer(k) == 0) network.inlet.push_back(node[k]);
    if (grid.layer(k) + 1 == grid.side) network.outlet.push_back(node[k]);
  }
  network.graph = equal_nodes(static_cast<std::size_t>(count));
  grid.for_faces([&](std::size_t a, std::size_t b) {
    if (node[a] == nobody || node[b] == nobody) return;
    const double along = fibre[a] == fibre[b] ? recipe.contrast : 1;
    add_edge(network.graph, static_cast<std::size_t>(node[a]), static_cast<std::size_t>(node[b]), along);
  });
  for (double& capacity : network.graph.capacity) capacity = spread_value(random, recipe.spread);
  heat_some(network);
  return network;
}

}  // namespace

NetworkGenerator fibres_generator() {
  return {.name = "fibres",
          .makes = "straight fibres in a cube, good conductors that touch poorly",
          .fraction = "part of the cube that they fill; 0 = all of it",
          .make = make};
}

}  // namespace superstep
