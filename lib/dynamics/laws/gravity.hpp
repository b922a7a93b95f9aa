#pragma once
/// Weight.

#include "core/vec3.hpp"

namespace superstep::dynamics {

/// Weight of a mass [kg] under the acceleration g [m/s2] along -z [N].
[[nodiscard]] constexpr Vec3 weight(double mass, double g) noexcept {
  return {0, 0, -mass * g};
}

}  // namespace superstep::dynamics
