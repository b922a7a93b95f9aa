#pragma once
/// Sliding friction.

#include "core/vec3.hpp"

namespace superstep::dynamics {

/// Friction per unit of normal force [-]: mu_d along the tangential velocity of the other body relative to
/// this one, regularised as v/sqrt(|v|^2 + v_s^2) so that bodies at rest relative to each other feel none.
///   slip        tangential part of v_other - v_this [m/s]
///   slip_speed  v_s [m/s], > 0
/// Source: Zohdi (2014), eqs 5-6 and 16-17; the regularisation is ours (the printed direction is undefined at
/// rest).
[[nodiscard]] inline Vec3 friction_direction(double coefficient, Vec3 slip, double slip_speed) noexcept {
  return (coefficient / std::sqrt(dot(slip, slip) + slip_speed * slip_speed)) * slip;
}

}  // namespace superstep::dynamics
