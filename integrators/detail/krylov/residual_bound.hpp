#pragma once
/// A bound of what the residual of a Lanczos solution adds up to.

#include <cstddef>
#include <vector>

namespace superstep {

/// Of u' = e_1 - T u, u(0) = 0, with T symmetric, tridiagonal, positive semidefinite and its off-diagonals
/// positive, bounds the integral over [0, t] of |u_m|, m the last entry, as T grows row by row.
///
/// |u_m'(s)| is the entry p(s) = |exp(-sT)|_m1, of one sign for all s, and its Laplace transform is a product
/// of ratios of positive numbers, beta_j / d_j with the pivots d_j of gI + T: known to full relative accuracy
/// however small. For every g > 0 the integral, that of (t - s) p(s), is at most the transform at g times the
/// largest (t - s) e^(gs): e^(gt-1)/g where gt >= 1. The least over a fixed grid of g counts: some three
/// times the integral itself where results have six digits, at a cost of one division for each g and row.
class ResidualBound {
 public:
  /// For times up to `longest` [s].
  explicit ResidualBound(double longest = 1);
  /// One more row: its diagonal entry, and what couples it to the row before (not used by the first) [1/s].
  void add_row(double alpha, double beta);
  /// The natural logarithm of the bound at t [s^2].
  [[nodiscard]] double log_integral(double t) const;

 private:
  std::vector<double> rate_, pivot_, log_transform_;  ///< for each g
  std::size_t rows_ = 0;
};

}  // namespace superstep
