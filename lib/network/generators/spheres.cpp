/// Spheres of many sizes near the cells of a cube: necks where they overlap, and bridges over gaps as long as
/// is asked for.

#include <algorithm>
#include <array>
#include <cmath>

#include "network/generators/exact.hpp"
#include "network/generators/grid.hpp"

namespace superstep {
namespace {

struct Sphere {
  std::array<double, 3> centre{};
  double radius = 0;
};

constexpr double jitter = 0.25;   // of a cell, either way
constexpr double largest = 0.68;  // radius, in cells: the largest overlap their neighbours

std::vector<Sphere> place(const Grid& grid, double ratio, Random& random) {
  std::vector<Sphere> spheres(grid.cells());
  for (std::size_t z = 0; z < grid.side; ++z)
    for (std::size_t y = 0; y < grid.side; ++y)
      for (std::size_t x = 0; x < grid.side; ++x) {
        Sphere& sphere = spheres[grid.cell(x, y, z)];
        const std::array<std::size_t, 3> at = {x, y, z};
        for (std::size_t d = 0; d < 3; ++d) {
          const double offset = jitter * (2 * random.uniform() - 1);
          sphere.centre[d] = static_cast<double>(at[d]) + offset;
        }
        sphere.radius = largest / spread_value(random, ratio);
      }
  return spheres;
}

double gap_between(const Sphere& a, const Sphere& b) {
  double square = 0;
  for (std::size_t d = 0; d < 3; ++d) {
    const double difference = a.centre[d] - b.centre[d];
    square += difference * difference;
  }
  return std::sqrt(square) - (a.radius + b.radius);
}

/// Calls each(a, b), a < b, for cells that share a face, an edge or a corner.
template <class Each>
void for_neighbours(const Grid& grid, Each each) {
  const auto side = static_cast<std::ptrdiff_t>(grid.side);
  const auto inside = [side](std::ptrdiff_t k) { return k >= 0 && k < side; };
  const auto cell = [side](std::ptrdiff_t x, std::ptrdiff_t y, std::ptrdiff_t z) {
    return static_cast<std::size_t>(x + side * (y + side * z));
  };
  for (std::ptrdiff_t z = 0; z < side; ++z)
    for (std::ptrdiff_t y = 0; y < side; ++y)
      for (std::ptrdiff_t x = 0; x < side; ++x)
        for (std::ptrdiff_t k = 14; k < 27; ++k) {  // the half of the 27 that comes later
          const std::ptrdiff_t i = x + k % 3 - 1, j = y + k / 3 % 3 - 1, l = z + k / 9 - 1;
          if (inside(i) && inside(j) && inside(l)) each(cell(x, y, z), cell(i, j, l));
        }
}

// Necks conduct the more the deeper the overlap, bridges fall off as 1/gap; the longest conducts its radius.
GeneratedNetwork make(const NetworkRecipe& recipe) {
  const Grid grid = Grid::of(recipe.size);
  GeneratedNetwork network = nodes_of(grid);
  Random random(recipe.seed);
  const auto spheres = place(grid, cube_root(recipe.spread), random);
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const double radius = spheres[k].radius;
    network.graph.capacity[k] = radius * radius * radius;
  }
  for_neighbours(grid, [&](std::size_t a, std::size_t b) {
    const double gap = gap_between(spheres[a], spheres[b]);
    const double smaller = std::min(spheres[a].radius, spheres[b].radius);
    if (gap <= 0) {
      const double part = std::min(1.0, -gap / smaller);
      add_edge(network.graph, a, b, recipe.contrast * smaller * (1 + std::sqrt(part)));
    } else if (gap <= recipe.fraction) {
      const double part = gap / recipe.fraction;
      add_edge(network.graph, a, b, smaller / (part + (1 - part) / recipe.contrast));
    }
  });
  return network;
}

}  // namespace

NetworkGenerator spheres_generator() {
  return {.name = "spheres",
          .makes = "spheres of many sizes with necks where they overlap and bridges over small gaps",
          .fraction = "longest gap that is bridged, over the distance of cells",
          .make = make};
}

}  // namespace superstep
