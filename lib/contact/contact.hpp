#pragma once
/// Contacts between overlapping spheres.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "packing/packing.hpp"

namespace superstep {

/// m contacts, structure of arrays, i < j, sorted by (i, j). In a periodic cell a pair may touch several
/// times, each time another image of j.
struct Contacts {
  std::vector<std::int32_t> i, j;   ///< [m] positions in the packing
  std::vector<double> overlap;      ///< [m] m; r_i + r_j - distance (negative inside an allowed bond gap)
  std::vector<double> neck_radius;  ///< [m] m

  std::vector<std::array<std::int8_t, 3>>
      image;  ///< [m] edges of the cell that j is moved by; empty = none is

  [[nodiscard]] std::size_t size() const noexcept { return i.size(); }
};

/// Vector from the centre of i to that of j, or of its image [m].
[[nodiscard]] inline Vec3 branch(const Packing& packing, const Contacts& contacts, std::size_t k) noexcept {
  const Vec3 between = packing.centre[static_cast<std::size_t>(contacts.j[k])] -
                       packing.centre[static_cast<std::size_t>(contacts.i[k])];
  if (contacts.image.empty()) return between;
  const auto& image = contacts.image[k];
  return between + packing.cell->shift({image[0], image[1], image[2]});
}

}  // namespace superstep
