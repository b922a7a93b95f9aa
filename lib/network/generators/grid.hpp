#pragma once
/// Cells of a cube, numbered along x first, and what most generators do with them.

#include <cstddef>
#include <cstdint>

#include "network/generators/network_generator.hpp"

namespace superstep {

struct Grid {
  std::size_t side = 0;  ///< cells along an edge

  /// The largest cube of at most `size` cells, of 8 at least.
  [[nodiscard]] static Grid of(std::size_t size) {
    std::size_t side = 2;
    while ((side + 1) * (side + 1) * (side + 1) <= size) ++side;
    return {side};
  }
  [[nodiscard]] std::size_t cells() const noexcept { return side * side * side; }
  [[nodiscard]] std::size_t cell(std::size_t x, std::size_t y, std::size_t z) const noexcept {
    return x + side * (y + side * z);
  }
  [[nodiscard]] std::size_t layer(std::size_t cell) const noexcept { return cell / (side * side); }

  /// Calls each(a, b) for all pairs of cells that share a face, a < b, in the order of a.
  template <class Each>
  void for_faces(Each each) const {
    for (std::size_t z = 0; z < side; ++z)
      for (std::size_t y = 0; y < side; ++y)
        for (std::size_t x = 0; x < side; ++x) {
          const std::size_t a = cell(x, y, z);
          if (x + 1 < side) each(a, a + 1);
          if (y + 1 < side) each(a, a + side);
          if (z + 1 < side) each(a, a + side * side);
        }
  }
};

/// Every sixteenth node is heated.
inline void heat_some(GeneratedNetwork& network) {
  constexpr std::size_t stride = 16;
  for (std::size_t k = stride / 2; k < network.graph.nodes(); k += stride)
    network.heated.push_back(static_cast<std::int32_t>(k));
}

/// A node for each cell; inlet and outlet are the lowest and the highest layer.
[[nodiscard]] inline GeneratedNetwork nodes_of(const Grid& grid) {
  GeneratedNetwork network{.graph = equal_nodes(grid.cells()), .inlet = {}, .outlet = {}, .heated = {}};
  for (std::size_t k = 0; k < grid.cells(); ++k) {
    const auto node = static_cast<std::int32_t>(k);
    if (grid.layer(k) == 0) network.inlet.push_back(node);
    if (grid.layer(k) + 1 == grid.side) network.outlet.push_back(node);
  }
  heat_some(network);
  return network;
}

}  // namespace superstep
