#pragma once
/// The little arithmetic that generators need and that a library for it would round differently elsewhere.

#include <cmath>

#include "core/random.hpp"

namespace superstep {

/// base^part for base >= 1 and part in [0, 1], from square roots alone: base^(1/2), base^(1/4), ...
/// multiplied where the binary digits of `part` say so; 40 of them.
[[nodiscard]] inline double power(double base, double part) {
  if (part >= 1) return base;
  double out = 1, root = base;
  for (int digit = 0; digit < 40; ++digit) {
    root = std::sqrt(root);
    part = 2 * part;
    if (part >= 1) {
      out *= root;
      part -= 1;
    }
  }
  return out;
}

/// Cube root of x >= 1 by Newton's iteration, the same number of times always.
[[nodiscard]] inline double cube_root(double x) {
  double root = x;
  for (int k = 0; k < 100; ++k) root = (2 * root + x / (root * root)) / 3;
  return root;
}

/// Between 1 and `contrast`, its logarithm uniform.
[[nodiscard]] inline double spread_value(Random& random, double contrast) {
  return contrast > 1 ? power(contrast, random.uniform()) : 1;
}

}  // namespace superstep
