#include "dynamics/volume_fraction.hpp"

#include <algorithm>
#include <numbers>

namespace superstep::dynamics {

double volume_below(double radius, double height) noexcept {
  const double filled = std::clamp(height + radius, 0.0, 2 * radius);  // depth of the cap
  return std::numbers::pi * filled * filled * (radius - filled / 3);
}

double volume_fraction(const Box& box, double lowest_wall, std::span<const Vec3> position,
                       std::span<const double> radius) noexcept {
  double volume = 0;
  for (std::size_t i = 0; i < position.size(); ++i)
    volume += volume_below(radius[i], lowest_wall - position[i].z);
  return volume / ((box.max.x - box.min.x) * (box.max.y - box.min.y) * (lowest_wall - box.min.z));
}

}  // namespace superstep::dynamics
