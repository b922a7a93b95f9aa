#pragma once
/// Pairs of spheres that are close to each other, in O(n) time and memory for any spread of radii.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec3.hpp"

namespace superstep {

/// Positions of two spheres, i < j.
struct NearPair {
  std::int32_t i, j;
};

/// All pairs with r_i + r_j + gap > |x_i - x_j|, sorted by (i, j). Pairs within 1e-12 of the limit (relative)
/// may be listed too: the caller decides on the exact overlap.
///   gap [m]     >= 0
///   candidates  how many distances were computed; per sphere it stays bounded as a packing grows
[[nodiscard]] std::vector<NearPair> near_pairs(std::span<const Vec3> centres, std::span<const double> radii,
                                               double gap = 0.0, std::size_t* candidates = nullptr);

}  // namespace superstep
