#pragma once
/// Packings on a cubic grid, a little shaken, of two sizes and as many materials as one likes: made by a
/// seed, the same bits with every compiler (see network/generators).

#include <cstdint>
#include <string>
#include <vector>

#include "packing/packing.hpp"

namespace superstep {

struct GridSettings {
  std::size_t count = 0;               ///< spheres wanted, >= 8; the largest cube of at most so many is made
  double spacing = 0;                  ///< m, of the centres before they are shaken
  double smallest = 0, largest = 0;    ///< m, diameters; uniform between
  double jitter = 0;                   ///< of the spacing, either way, 0 to 0.5
  std::vector<std::string> materials;  ///< names; empty = one without a name
  std::vector<double> shares;          ///< number fractions of the materials, > 0, or empty: equal
  std::uint64_t seed = 1;
};

/// Layers lie along z; ids count along x first.
[[nodiscard]] Packing grid_packing(const GridSettings& settings);

}  // namespace superstep
