#pragma once
/// Close pairs of spheres across the sides of a periodic cell.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec3.hpp"
#include "packing/cell.hpp"

namespace superstep {

/// Sphere j, moved by so many edges of the cell, is near sphere i. i < j; or i = j, with a sphere's own
/// image, once for each two opposite ones.
struct ImagePair {
  std::int32_t i, j;
  std::array<std::int8_t, 3> image;
};

/// All pairs as `near_pairs` lists them, each with the image at which it is near; a pair may be near at
/// several. Sorted by (i, j), then by image. Centres must lie inside the cell along its periodic edges.
///   gap [m]  >= 0
/// Throws InputError when the cell is so thin that a sphere would meet more than a hundred of its images.
[[nodiscard]] std::vector<ImagePair> periodic_pairs(std::span<const Vec3> centres,
                                                    std::span<const double> radii, double gap,
                                                    const Cell& cell);

}  // namespace superstep
