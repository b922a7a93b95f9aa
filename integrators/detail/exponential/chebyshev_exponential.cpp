#include "integrators/detail/exponential/chebyshev_exponential.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace superstep {

TruncatedSeries exponential_series(double z, double tolerance, const ExpansionScale& scale) {
  if (!(z > 0)) return {{1.0}, 0};
  // e^-z I_k(z) falls like exp(-k^2/(2z)) up to k ~ z and faster beyond: start well past the wanted tail.
  const double factor = 1 + scale.rate + scale.turn;  // by which the rest may count for more
  const double decades = std::log(1e20 / std::min(tolerance, 1.0) * std::min(factor, 1e100));
  const double guess = std::sqrt(2 * z * decades) + decades + 10;
  const auto start = static_cast<std::size_t>(guess);
  std::vector<double> c(start + 2, 0.0);
  c[start] = 1e-280;
  for (std::size_t k = start; k-- > 0;) {
    c[k] = c[k + 2] + 2 * static_cast<double>(k + 1) / z * c[k + 1];
    constexpr double large = 1e250;
    if (c[k] > large)
      for (std::size_t j = k; j <= start; ++j) c[j] /= large;
  }
  for (std::size_t k = 1; k < c.size(); ++k) c[k] *= 2;
  double sum = 0, tail = 0, uniform_tail = 0, left_out = 0;
  for (std::size_t k = c.size(); k-- > 0;) sum += c[k];
  std::size_t last = c.size() - 1;
  while (last > 0) {
    const auto k = static_cast<double>(last);
    const double growth = k * k / z, turned = growth / 6 * scale.turn;
    tail += c[last] / sum * (scale.by_rate ? growth * (scale.rate + turned) : 1);
    uniform_tail += c[last] / sum * (scale.deviation + growth * (scale.uniform_rate + turned));
    // What is dropped is missed, and the scaling of the rest, which keeps a uniform state, errs by as much
    // again.
    const double without = 2 * std::min(tail, uniform_tail);
    if (without > tolerance) break;
    left_out = without;
    --last;
  }
  c.resize(last + 1);
  double kept = 0;
  for (std::size_t k = c.size(); k-- > 0;) kept += c[k];
  for (double& coefficient : c) coefficient /= kept;
  return {std::move(c), left_out};
}

std::vector<double> integrated_coefficients(const std::vector<double>& c) {
  // With a_k = e^-z I_k: a_k(z) - a_k(0) = (J_{k-1} - 2 J_k + J_{k+1})/2, J_k = integral of a_k; backward,
  // all positive.
  std::vector<double> d(c.size());
  double above = 0, here = 0;  // J_{k+1}, J_k, starting past the end
  for (std::size_t k = c.size(); k-- > 0;) {
    // here is J_k, above is J_{k+1}
    d[k] = k == 0 ? here : 2 * here;
    if (k == 0) break;
    const double below = 2 * here - above + c[k];  // c_k = 2 a_k
    above = here;
    here = below;
  }
  return d;
}

}  // namespace superstep
