#pragma once
/// Random sequential addition: particles are dropped into a box one after the other, where there is room.

#include <cstdint>
#include <functional>
#include <vector>

#include "dynamics/walls.hpp"

namespace superstep::dynamics {

/// Told now and then which part of the spheres is placed, never of what is done in a moment.
using Placed = std::function<void(double part)>;

/// Centres of `count` spheres of one radius [m] that overlap neither each other nor the walls.
/// O(count) as long as there is room; the same seed gives the same centres with every compiler.
/// Throws NumericalError when no place is found for a sphere in a million attempts (random sequential
/// addition jams at a volume fraction of 0.38), with the number that were placed, and at once where no
/// arrangement at all would fit. Source: Widom (1966),
/// doi:10.1063/1.1726548; Zohdi (2014), section 7.1, remark 2.
[[nodiscard]] std::vector<Vec3> random_addition(const Box& box, std::size_t count, double radius,
                                                std::uint64_t seed);

/// The same for spheres of these radii [m], placed in this order: largest first finds room longest.
[[nodiscard]] std::vector<Vec3> random_addition(const Box& box, const std::vector<double>& radii,
                                                std::uint64_t seed, const Placed& placed = {});

}  // namespace superstep::dynamics
