#include "integrators/detail/krylov/rational_error.hpp"

#include <algorithm>
#include <cmath>

#include "integrators/detail/krylov/decay.hpp"

namespace superstep {
namespace {

/// The integral over [0, t] of exp(-(t - s) a) exp(-s b).
double decayed_in_turn(double a, double b, double t) {
  return std::exp(-t * std::min(a, b)) * decayed(std::abs(a - b), t);
}

/// The same of exp(-(t - s) a) s phi_1(-s b).
double decayed_into(double a, double b, double t) {
  const double slower = std::min(a, b), faster = std::max(a, b);
  constexpr double few = 1e-3;  // an exponent: three terms of the series are exact there
  if (faster * t < few) return t * t * (0.5 - t * (a + b) / 6 + t * t * (a * a + a * b + b * b) / 24);
  return (decayed(slower, t) - decayed_in_turn(a, b, t)) / faster;
}

}  // namespace

RationalError rational_error(double pole, std::span<const double> rate, std::span<const double> vectors,
                             double t) {
  constexpr double between = 1.1, ratio = 1.5, least = 0.03, far = 1e6;
  constexpr int samples = 23;       // up to some 200/t
  const double fastest = 1e30 / t;  // beyond that rates are roundings, and large numbers
  const std::size_t m = rate.size();
  RationalError error;
  const auto look_at = [&](double lambda) {
    double next = 0, square = 0;
    for (std::size_t k = 0; k < m; ++k) {
      const double own = std::min(rate[k], fastest);
      const double value = vectors[k * m] * (1 / pole + lambda) * (1 + pole * own) *
                           (decayed_in_turn(lambda, own, t) - decayed_into(lambda, own, t) / pole);
      next += vectors[k * m + m - 1] * value;
      square += value * value;
    }
    error.next = std::max(error.next, between * std::abs(next));
    error.images = std::max(error.images, between * std::sqrt(square));
  };
  look_at(0);
  double x = least;
  for (int k = 0; k < samples; ++k, x *= ratio) look_at(x / t);
  look_at(far / t);
  return error;
}

}  // namespace superstep
