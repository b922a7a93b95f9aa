#pragma once
/// A step without corners.

#include <algorithm>

namespace superstep::dynamics {

/// 0 for t <= 0, 1 for t >= 1, and in between t^2 (3 - 2 t): value and slope are continuous everywhere.
[[nodiscard]] constexpr double smooth_step(double t) noexcept {
  const double inside = std::clamp(t, 0.0, 1.0);
  return inside * inside * (3 - 2 * inside);
}

}  // namespace superstep::dynamics
