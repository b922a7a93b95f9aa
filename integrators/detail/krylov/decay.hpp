#pragma once
/// Integrals of an exponential decay.

#include <cmath>

namespace superstep {

/// t phi_1(-t lambda), the integral of exp(-s lambda) from 0 to t.
[[nodiscard]] inline double decayed(double lambda, double t) {
  const double x = lambda * t;
  return std::abs(x) < 1e-8 ? t * (1 - x / 2) : -std::expm1(-x) / lambda;
}

}  // namespace superstep
