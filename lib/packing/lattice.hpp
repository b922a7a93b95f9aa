#pragma once
/// Equal spheres on a simple cubic lattice: made layer by layer, so that nobody need hold all of them.

#include <array>
#include <cstdint>
#include <string>

#include "packing/packing.hpp"

namespace superstep {

struct Lattice {
  std::array<std::int64_t, 3> cells{};  ///< along x, y, z, > 0
  double spacing = 0, diameter = 0;     ///< m, > 0

  /// Spheres of one layer, all of which have the same z, and of all layers.
  [[nodiscard]] std::int64_t layer() const noexcept { return cells[0] * cells[1]; }
  [[nodiscard]] std::int64_t size() const noexcept { return layer() * cells[2]; }
};

/// The rule that the diameter breaks; empty = none. Spheres that hold the centres of others are no packing,
/// and mostly a slip in one of the two lengths.
[[nodiscard]] std::string broken_rule(const Lattice& lattice);

/// The spheres of layers [first, last). Ids count along x first, then along y; the first sphere of all is
/// number 0 and stands at the origin. A part of the layers says what it is a part of.
[[nodiscard]] Packing lattice_layers(const Lattice& lattice, std::int64_t first, std::int64_t last);

}  // namespace superstep
