#pragma once
/// Powers of strains.

#include <cmath>

namespace superstep::dynamics {

/// strain^exponent for strain >= 0. The usual exponents 1 and 2 cost no call of pow.
[[nodiscard]] inline double strain_power(double strain, double exponent) noexcept {
  if (exponent == 2.0) return strain * strain;
  if (exponent == 1.0) return strain;
  return std::pow(strain, exponent);
}

}  // namespace superstep::dynamics
