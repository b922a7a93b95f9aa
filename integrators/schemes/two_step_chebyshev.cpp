#include "integrators/schemes/two_step_chebyshev.hpp"

#include <algorithm>
#include <cmath>

#include "integrators/schemes/stabilised_schemes.hpp"

namespace superstep {
namespace {

constexpr double at_w0 = 1.1;  // T_s(w0): what lies inside the interval is damped by that

/// w0 - 1, by T_s(w0) = cosh(s theta).
double excess(int stages) {
  const double half = std::sinh(0.5 * std::acosh(at_w0) / stages);
  return 2 * half * half;
}

}  // namespace

TwoStepChebyshev two_step_chebyshev(int stages, double ratio) {
  const double s = stages, d = excess(stages), w0 = 1 + d;
  const double first = s * std::sinh(std::acosh(at_w0)) / std::sqrt(d * (2 + d));
  const double second = (s * s * at_w0 - w0 * first) / (d * (2 + d));
  // Both conditions, w1 eliminated: q^2 (1 - r) nu^2 - (1 + 2 r q + q^2) nu + 1 - r = 0. The smaller root,
  // free of cancellation, is the one that tends to 0 with a long step before.
  const double r = at_w0 * second / (first * first), square = ratio * ratio;
  const double middle = 1 + 2 * r * ratio + square;
  const double before = 2 * (1 - r) / (middle + std::sqrt(middle * middle - 4 * square * (1 - r) * (1 - r)));
  const double reach = (1 + before * ratio) / (1 - before);
  return {before, reach, (1 + w0) * first / (at_w0 * reach)};
}

int two_step_stages(double z, double ratio) {
  constexpr int many = 1000;
  constexpr double countless = 1e9;
  const double wanted = many * std::sqrt(z / two_step_chebyshev(many, ratio).beta);
  if (!(wanted < countless)) return static_cast<int>(countless) + 1;
  int stages = std::max(fewest_two_step_stages, static_cast<int>(wanted) - 2);
  while (two_step_chebyshev(stages, ratio).beta < z) ++stages;
  return stages;
}

void two_step_recurrence(int stages, const TwoStepChebyshev& coefficients, ThreeTermScheme& scheme) {
  first_order_chebyshev(stages, excess(stages), scheme, coefficients.reach);
  scheme.uses_first_derivative = true;
}

double two_step_error(const TwoStepChebyshev& coefficients, const ThreeTermScheme& scheme, double ratio) {
  const double nu = coefficients.before;
  return ((1 + nu * ratio * ratio * ratio) / 6 - (1 - nu) * taylor_coefficient(scheme, 3)) / (1 + nu * ratio);
}

}  // namespace superstep
