#include "integrators/schemes/rock_polynomial.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <span>
#include <stdexcept>
#include <utility>

#include "core/index.hpp"

namespace superstep {
namespace {

/// Real and imaginary parts of the roots, one pair after the other, and l / s^2: all tend to a limit as s
/// grows.
using Unknowns = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 5, 1>;
using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 5, 5>;

constexpr double damped_end(int order) noexcept {
  return order == 4 ? 0.85 : 0.95;
}

RockPolynomial polynomial_of(int order, int stages, const Unknowns& u) {
  RockPolynomial out{.order = order, .length = u[order] * stages * stages};
  for (int k = 0; k < order / 2; ++k) {
    out.real[at(k)] = u[2 * k];
    out.imaginary[at(k)] = u[2 * k + 1];
  }
  return out;
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

/// Walks the recurrence of P_{s-p} in its normalisation P_j(1) = 1,
///   P_j = (m_j + mt_j z) P_{j-1} + n_j P_{j-2},   m_j + n_j = 1,
/// handing each (j, m_j, mt_j) to `take`. Inner products are sums over Chebyshev nodes, exact for the degrees
/// that occur (Stieltjes procedure).
template <class Take>
void walk_recurrence(int stages, const RockPolynomial& polynomial, Take take) {
  constexpr std::size_t room = at(rock_most_stages(2)) + 2;
  std::array<double, room> x, squared_weight, now, before;
  const std::size_t degree = at(stages - polynomial.order), nodes = at(stages) + 1;
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

/// Residuals of R'(0) = ... = R^(p)(0) = 1 and of the damping at -l.
Unknowns residuals(int order, int stages, const Unknowns& u) {
  const RockPolynomial polynomial = polynomial_of(order, stages, u);
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
  Unknowns out(order + 1);
  double factorial = 1;
  for (int k = 1; k <= order; ++k) {
    factorial *= k;
    out[k - 1] = factorial * taylor[at(k)] - 1;
  }
  out[order] = sign * end * value(w, -polynomial.length) / damped_end(order) - 1;
  return out;
}

/// Solutions for some numbers of stages, most first, to about four digits.
struct Known {
  int stages;
  std::array<double, 5> unknowns;
};
constexpr std::array<Known, 4> known_of_order_two = {{{200, {-1.3348, 1.3656, 0.8026}},
                                                      {10, {-1.3182, 1.3538, 0.7916}},
                                                      {5, {-1.2700, 1.3170, 0.7580}},
                                                      {3, {-1.1650, 1.2216, 0.6741}}}};
constexpr std::array<Known, 5> known_of_order_four = {{{200, {-0.3065, 3.5839, -2.5008, 1.3179, 0.3511}},
                                                       {16, {-0.2841, 3.5074, -2.4531, 1.2997, 0.3398}},
                                                       {8, {-0.2382, 3.2842, -2.3108, 1.2408, 0.3061}},
                                                       {6, {-0.2184, 3.0658, -2.1637, 1.1713, 0.2717}},
                                                       {5, {-0.2206, 2.8590, -2.0142, 1.0900, 0.2371}}}};

/// Between known solutions, which vary almost linearly with 1/s^2.
Unknowns first_guess(int order, int stages) {
  const auto known = order == 4 ? std::span<const Known>(known_of_order_four) : known_of_order_two;
  const auto inverse_square = [](int s) { return 1.0 / (static_cast<double>(s) * s); };
  std::size_t row = 1;
  while (stages < known[row].stages) ++row;
  const Known &low = known[row - 1], &high = known[row];
  const double part = (inverse_square(stages) - inverse_square(low.stages)) /
                      (inverse_square(high.stages) - inverse_square(low.stages));
  Unknowns out(order + 1);
  for (int k = 0; k <= order; ++k) out[k] = std::lerp(low.unknowns[at(k)], high.unknowns[at(k)], part);
  return out;
}

Jacobian difference_jacobian(int order, int stages, const Unknowns& u, const Unknowns& f) {
  Jacobian jacobian(order + 1, order + 1);
  for (int k = 0; k <= order; ++k) {
    const double change = 1e-7 * std::abs(u[k]);
    Unknowns moved = u;
    moved[k] += change;
    jacobian.col(k) = (residuals(order, stages, moved) - f) / change;
  }
  return jacobian;
}

RockPolynomial solve(int order, int stages) {
  constexpr int most_steps = 20;
  constexpr double accepted = 1e-10;
  Unknowns u = first_guess(order, stages), f = residuals(order, stages, u);
  for (int step = 0; step < most_steps; ++step) {
    const Unknowns next = u - difference_jacobian(order, stages, u, f).partialPivLu().solve(f);
    const Unknowns next_f = residuals(order, stages, next);
    // Newton's method ends where rounding keeps the residual from falling.
    if (f.norm() < accepted && !(next_f.norm() < 0.5 * f.norm())) return polynomial_of(order, stages, u);
    u = next;
    f = next_f;
  }
  throw std::logic_error("no stability polynomial found for this order and number of stages");
}

}  // namespace

std::array<double, 5> RockPolynomial::weight() const {
  std::array<double, 5> out{1};
  for (std::size_t k = 0; k < at(order / 2); ++k) {
    const double square = real[k] * real[k] + imaginary[k] * imaginary[k];
    out = product(out, {1, -2 * real[k] / square, 1 / square});
  }
  return out;
}

const RockPolynomial& rock_polynomial(int order, int stages) {
  struct Solved {
    std::once_flag once;
    RockPolynomial polynomial;
  };
  constexpr std::size_t room = at(rock_most_stages(2)) + 1;
  static std::array<std::array<Solved, room>, 2> all;
  Solved& one = all[order == 4 ? 1 : 0][at(stages)];
  std::call_once(one.once, [&] { one.polynomial = solve(order, stages); });
  return one.polynomial;
}

void set_rock_recurrence(int stages, const RockPolynomial& polynomial, ThreeTermScheme& scheme) {
  walk_recurrence(stages, polynomial, [&](std::size_t j, double m, double mt) {
    scheme.m[j] = m;
    scheme.n[j] = 1 - m;
    scheme.mt[j] = mt;
  });
}

}  // namespace superstep
