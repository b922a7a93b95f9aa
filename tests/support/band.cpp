#include "support/band.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace superstep::test {

Graph band(bool radiating, bool changing) {
  constexpr std::size_t node_count = 30'000;
  Graph graph;
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> number(0.5, 2.0);
  for (std::size_t k = 0; k < node_count; ++k) {
    graph.id.push_back(static_cast<std::int64_t>(k));
    graph.capacity.push_back(number(random));
    graph.source.push_back(k % 50 == 3 ? number(random) : 0);
    graph.initial.push_back(std::sin(0.01 * static_cast<double>(k)));
    graph.is_fixed.push_back(k % 400 == 7 ? 1 : 0);
    graph.fixed_value.push_back(k % 3 == 0 ? 1 : -1);
    const auto node = static_cast<std::int32_t>(k);
    for (std::size_t neighbour = k + 1; neighbour < std::min(k + 41, node_count); ++neighbour) {
      if (neighbour > k + 1 && random() % 8 != 0) continue;
      graph.i.push_back(node);
      graph.j.push_back(static_cast<std::int32_t>(neighbour));
      graph.conductance.push_back(number(random));
    }
    if (k % 90 == 5) graph.convection.push_back({node, 0.3, 0.5, -1});
    if (radiating && k % 70 == 1) graph.radiation.push_back({node, 0.2, 0.7, -1});
  }
  if (changing) {
    graph.tables.push_back({{0, 1, 2}, {0, 3, -1}});
    for (std::int32_t k = 9; k < static_cast<std::int32_t>(node_count); k += 500)
      graph.tabled_sources.push_back({k, 0});
  }
  return graph;
}

Stage stage_of(std::size_t k, double h, const double* y1, const double* y2, const double* y0,
               const double* f0) {
  if (k == 0) return {.y1 = y1, .a = 1, .d = h};
  return {.y1 = y1, .a = 1.3, .d = h, .y2 = y2, .b = -0.4, .y0 = y0, .c = 0.1, .f0 = f0, .e = -0.2 * h};
}

}  // namespace superstep::test
