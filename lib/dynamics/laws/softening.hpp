#pragma once
/// Hot material is softer.

#include <algorithm>
#include <limits>

namespace superstep::dynamics {

struct Softening {
  double temperature = std::numeric_limits<double>::infinity();  ///< T* [K]; infinity = no softening
  double floor = 0;                                              ///< K_lim [N/m2], >= 0
};

/// Stiffness at temperature T: max(K_0 (1 - T/T*), K_lim) [N/m2]. Source: Zohdi (2014), section 7.
[[nodiscard]] inline double softened(double stiffness, const Softening& softening,
                                     double temperature) noexcept {
  return std::max(stiffness * (1 - temperature / softening.temperature), softening.floor);
}

}  // namespace superstep::dynamics
