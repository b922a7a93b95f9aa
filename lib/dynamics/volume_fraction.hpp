#pragma once
/// How densely the press is filled.

#include <span>

#include "core/vec3.hpp"
#include "dynamics/walls.hpp"

namespace superstep::dynamics {

/// Volume of the part of a sphere that lies below a plane [m3]; `height` of the plane above the centre [m].
[[nodiscard]] double volume_below(double radius, double height) noexcept;

/// Particle volume below z* over the box's volume below z*: (box area) (z* - floor). Overlaps count twice.
/// Source: Zohdi (2014), section 7.1, remark 1; z* is the lowest height that the upper wall ever reaches [m].
[[nodiscard]] double volume_fraction(const Box& box, double lowest_wall, std::span<const Vec3> position,
                                     std::span<const double> radius) noexcept;

}  // namespace superstep::dynamics
