#include "integrators/schemes/rock_polynomial.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <span>
#include <stdexcept>
#include <utility>

namespace superstep {
namespace {

constexpr double damped_end = 0.85;

/// Real and imaginary parts of the two roots, and l / s^2: all tend to a limit as s grows.
using Unknowns = Eigen::Matrix<double, 5, 1>;

RockPolynomial polynomial_of(int stages, const Unknowns& u) {
  return {.real = {u[0], u[2]}, .imaginary = {u[1], u[3]}, .length = u[4] * stages * stages};
}

std::array<double, 5> product(const std::array<double, 5>& a, const std::array<double, 5>& b) {
  std::array<double, 5> out{};
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; i + j < 5; ++j) out[i + j] += a[i] * b[j];
  return out;
}

double value(const std::array<double, 5>& coefficients, double z) {
  double sum = 0;
  for (std::size_t k = coefficients.size(); k-- > 0;) sum = sum * z + coefficients[k];
  return sum;
}

/// Walks the recurrence of P_{s-4} in its normalisation P_j(1) = 1,
///   P_j = (m_j + mt_j z) P_{j-1} + n_j P_{j-2},   m_j + n_j = 1,
/// handing each (j, m_j, mt_j) to `take`. Inner products are sums over Chebyshev nodes, exact for the degrees
/// that occur (Stieltjes procedure).
template <class Take>
void walk_recurrence(int stages, const RockPolynomial& polynomial, Take take) {
  constexpr std::size_t room = static_cast<std::size_t>(rock_most_stages) + 1;
  std::array<double, room> x, squared_weight, now, before;
  const auto degree = static_cast<std::size_t>(stages - 4), nodes = degree + 5;  // 2 nodes > 2 degree + 9
  const auto w = polynomial.weight();
  for (std::size_t k = 0; k < nodes; ++k) {
    const double angle =
        std::numbers::pi * (2 * static_cast<double>(k) + 1) / (2 * static_cast<double>(nodes));
    const double half = std::sin(angle / 2);
    x[k] = 1 - 2 * half * half;
    const double at_node = value(w, -polynomial.length * half * half);
    squared_weight[k] = at_node * at_node;
    now[k] = 1;
    before[k] = 0;
  }
  double norm_before = 0;
  for (std::size_t j = 1; j <= degree; ++j) {
    double norm = 0, shift = 0, mixed = 0;
    for (std::size_t k = 0; k < nodes; ++k) {
      const double weighted = squared_weight[k] * now[k];
      norm += weighted * now[k];
      shift += weighted * now[k] * (1 - x[k]);  // 1 - alpha, free of cancellation
      mixed += weighted * before[k] * x[k];
    }
    const double one_minus_alpha = shift / norm, beta = j > 1 ? mixed / norm_before : 0;
    const double scale = one_minus_alpha - beta, m = one_minus_alpha / scale;
    for (std::size_t k = 0; k < nodes; ++k) {
      const double next = (m - (1 - x[k]) / scale) * now[k] + (1 - m) * before[k];
      before[k] = std::exchange(now[k], next);
    }
    norm_before = norm;
    take(j, m, 2 / (polynomial.length * scale));
  }
}

/// Residuals of R'(0) = ... = R''''(0) = 1 and of the damping at -l.
Unknowns residuals(int stages, const Unknowns& u) {
  const RockPolynomial polynomial = polynomial_of(stages, u);
  std::array<double, 5> series{1}, series_before{1};  // of P_j in z
  double end = 1, end_before = 1;                     // P_j(-l)
  walk_recurrence(stages, polynomial, [&](std::size_t, double m, double mt) {
    std::array<double, 5> next{};
    for (std::size_t k = 0; k < 5; ++k)
      next[k] = m * series[k] + (1 - m) * series_before[k] + (k > 0 ? mt * series[k - 1] : 0);
    series_before = std::exchange(series, next);
    end_before = std::exchange(end, (m - mt * polynomial.length) * end + (1 - m) * end_before);
  });
  const auto w = polynomial.weight();
  const auto taylor = product(series, w);
  const double sign = stages % 2 == 0 ? 1 : -1;
  Unknowns out;
  out << taylor[1] - 1, 2 * taylor[2] - 1, 6 * taylor[3] - 1, 24 * taylor[4] - 1,
      sign * end * value(w, -polynomial.length) / damped_end - 1;
  return out;
}

/// Between solutions, which vary almost linearly with 1/s^2.
Unknowns first_guess(int stages) {
  struct Row {
    int stages;
    double unknowns[5];
  };
  static constexpr Row rows[] = {{200, {-0.3065, 3.5839, -2.5008, 1.3179, 0.3511}},
                                 {16, {-0.2841, 3.5074, -2.4531, 1.2997, 0.3398}},
                                 {8, {-0.2382, 3.2842, -2.3108, 1.2408, 0.3061}},
                                 {6, {-0.2184, 3.0658, -2.1637, 1.1713, 0.2717}},
                                 {5, {-0.2206, 2.8590, -2.0142, 1.0900, 0.2371}}};
  const auto inverse_square = [](int s) { return 1.0 / (static_cast<double>(s) * s); };
  const Row* row = rows + 1;
  while (stages < row->stages) ++row;
  const Row &low = row[-1], &high = *row;
  const double part = (inverse_square(stages) - inverse_square(low.stages)) /
                      (inverse_square(high.stages) - inverse_square(low.stages));
  Unknowns out;
  for (int k = 0; k < 5; ++k) out[k] = std::lerp(low.unknowns[k], high.unknowns[k], part);
  return out;
}

Eigen::Matrix<double, 5, 5> difference_jacobian(int stages, const Unknowns& u, const Unknowns& f) {
  Eigen::Matrix<double, 5, 5> jacobian;
  for (int k = 0; k < 5; ++k) {
    const double change = 1e-7 * std::abs(u[k]);
    Unknowns moved = u;
    moved[k] += change;
    jacobian.col(k) = (residuals(stages, moved) - f) / change;
  }
  return jacobian;
}

RockPolynomial solve(int stages) {
  constexpr int most_steps = 20;
  constexpr double accepted = 1e-10;
  Unknowns u = first_guess(stages), f = residuals(stages, u);
  for (int step = 0; step < most_steps; ++step) {
    const Unknowns next = u - difference_jacobian(stages, u, f).partialPivLu().solve(f);
    const Unknowns next_f = residuals(stages, next);
    // Newton's method ends where rounding keeps the residual from falling.
    if (f.norm() < accepted && !(next_f.norm() < 0.5 * f.norm())) return polynomial_of(stages, u);
    u = next;
    f = next_f;
  }
  throw std::logic_error("no stability polynomial of order four found for this number of stages");
}

}  // namespace

std::array<double, 5> RockPolynomial::weight() const {
  std::array<double, 5> out{1};
  for (std::size_t k = 0; k < 2; ++k) {
    const double square = real[k] * real[k] + imaginary[k] * imaginary[k];
    out = product(out, {1, -2 * real[k] / square, 1 / square});
  }
  return out;
}

const RockPolynomial& rock_polynomial(int stages) {
  constexpr std::size_t room = static_cast<std::size_t>(rock_most_stages) + 1;
  static std::array<std::once_flag, room> solved;
  static std::array<RockPolynomial, room> polynomials;
  const auto s = static_cast<std::size_t>(stages);
  std::call_once(solved[s], [&] { polynomials[s] = solve(stages); });
  return polynomials[s];
}

void set_rock_recurrence(int stages, const RockPolynomial& polynomial, ThreeTermScheme& scheme) {
  walk_recurrence(stages, polynomial, [&](std::size_t j, double m, double mt) {
    scheme.m[j] = m;
    scheme.n[j] = 1 - m;
    scheme.mt[j] = mt;
  });
}

}  // namespace superstep
