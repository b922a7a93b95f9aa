#pragma once
/// Contacts between overlapping spheres.

#include <cstdint>
#include <string>
#include <vector>

#include "packing/packing.hpp"

namespace superstep {

/// m contacts, structure of arrays, i < j, sorted by (i, j).
struct Contacts {
  std::vector<std::int32_t> i, j;   ///< [m] positions in the packing
  std::vector<double> overlap;      ///< [m] m; r_i + r_j - distance (negative inside an allowed bond gap)
  std::vector<double> neck_radius;  ///< [m] m

  [[nodiscard]] std::size_t size() const noexcept { return i.size(); }
};

}  // namespace superstep
