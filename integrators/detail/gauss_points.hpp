#pragma once
/// What enters during a step, where the step is a polynomial in time.

#include <utility>

namespace superstep {

/// Integral of value(t) from begin to end by three Gauss-Legendre points: exact to degree 5.
template <class Value>
[[nodiscard]] double gauss_integral(double begin, double end, const Value& value) {
  constexpr double node = 0.7745966692414834;  // sqrt(3/5)
  const double middle = 0.5 * (begin + end), half = 0.5 * (end - begin);
  double sum = 0;
  for (const auto& [position, weight] : {std::pair{-node, 5.0 / 9}, {0.0, 8.0 / 9}, {node, 5.0 / 9}})
    sum += weight * half * value(middle + position * half);
  return sum;
}

}  // namespace superstep
