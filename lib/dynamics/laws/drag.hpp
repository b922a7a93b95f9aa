#pragma once
/// Drag of the medium between the particles.

#include <numbers>

#include "core/vec3.hpp"

namespace superstep::dynamics {

struct DragLaw {
  double coefficient = 0;  ///< c_o [kg/(m s)]; the particle's coefficient is c_o 6 pi R
  Vec3 medium_velocity;    ///< m/s
};

/// -c_env (v - v_env), c_env = c_o 6 pi R [N]. Source: Zohdi (2014), eq. 20 and section 7.
[[nodiscard]] constexpr Vec3 drag_force(const DragLaw& law, double radius, Vec3 velocity) noexcept {
  return (-law.coefficient * 6 * std::numbers::pi * radius) * (velocity - law.medium_velocity);
}

}  // namespace superstep::dynamics
