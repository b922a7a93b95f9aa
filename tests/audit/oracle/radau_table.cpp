#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "audit/oracle/radau.hpp"

namespace superstep::audit {
namespace {

using Long = long double;

/// P_s(x) - P_{s-1}(x), whose zeros in (-1, 1] are the right Radau points.
Long radau_polynomial(int s, Long x) {
  Long before = 1, now = x;
  for (int k = 2; k <= s; ++k) {
    const Long next = ((2 * k - 1) * x * now - (k - 1) * before) / k;
    before = now;
    now = next;
  }
  return now - before;
}

/// Zeros by bisection between sign changes on a fine grid: slow, and once.
Eigen::Matrix<Long, Eigen::Dynamic, 1> radau_nodes(int s) {
  Eigen::Matrix<Long, Eigen::Dynamic, 1> c(s);
  int found = 0;
  constexpr int grid = 4000;
  const auto x_of = [](int k) { return -std::cos(std::numbers::pi_v<Long> * (k + 0.5L) / (grid + 1)); };
  for (int k = 0; k < grid && found + 1 < s; ++k) {
    Long a = x_of(k), b = x_of(k + 1);
    if (radau_polynomial(s, a) * radau_polynomial(s, b) > 0) continue;
    for (int halving = 0; halving < 80; ++halving) {
      const Long middle = (a + b) / 2;
      (radau_polynomial(s, a) * radau_polynomial(s, middle) > 0 ? a : b) = middle;
    }
    c(found++) = (1 + (a + b) / 2) / 2;
  }
  c(s - 1) = 1;
  return c;
}

}  // namespace

RadauTable::RadauTable(int points) : s(points) {
  using Matrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;
  const auto nodes = radau_nodes(s);
  Matrix powers(s, s), integrals(s, s);  // c_i^(k-1) and c_i^k/k
  for (int i = 0; i < s; ++i)
    for (int k = 0; k < s; ++k) {
      powers(i, k) = std::pow(nodes(i), k);
      integrals(i, k) = std::pow(nodes(i), k + 1) / (k + 1);
    }
  const Matrix a = integrals * powers.inverse(), a_inverse = a.inverse();
  c = nodes.cast<double>();
  inverse = a_inverse.cast<double>();

  const Eigen::EigenSolver<Eigen::MatrixXd> solver(inverse);
  lambda.resize(s);
  vectors.resize(s, s);
  int complex_pairs = 0;
  for (int k = 0; k < s; ++k) {
    const auto value = solver.eigenvalues()(k);
    const bool real = std::abs(value.imag()) < 1e-9 * std::abs(value);
    if (!real && value.imag() < 0) continue;  // the conjugate of one that is kept
    const int to = real ? 0 : 1 + 2 * complex_pairs++;
    lambda(to) = real ? value.real() : value;
    vectors.col(to) = solver.eigenvectors().col(k);
    if (real) continue;
    lambda(to + 1) = std::conj(value);
    vectors.col(to + 1) = vectors.col(to).conjugate();
  }
  vectors_inverse = vectors.inverse();

  // The embedded formula uses f(t_0) with the weight 1/lambda_0 and is exact for degrees below s.
  Matrix conditions(s, s);
  Eigen::Matrix<Long, Eigen::Dynamic, 1> right(s), weights(s);
  for (int k = 0; k < s; ++k) {
    for (int i = 0; i < s; ++i) conditions(k, i) = powers(i, k);
    right(k) = 1.0L / (k + 1) - (k == 0 ? 1 / static_cast<Long>(lambda(0).real()) : 0);
  }
  weights = conditions.fullPivLu().solve(right);
  error = ((weights - a.row(s - 1).transpose()).transpose() * a_inverse).transpose().cast<double>();
}

}  // namespace superstep::audit
