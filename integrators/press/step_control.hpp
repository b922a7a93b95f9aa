#pragma once
/// Step sizes from the rate at which a fixed-point iteration converges.
/// Source: Zohdi (2014), eqs 30, 47-49 and Algorithm 1.

#include <cmath>

namespace superstep::dynamics {

/// How one field's iteration went: w_k = sum |y^k - y^(k-1)| / sum |y^k - y^L|, 0 when nothing moves.
///
/// The paper's first error compares with y^0 = y^L and is identically 1, so it tells nothing. Here iterate 0
/// is an Euler predictor, and the first error that counts is that of iterate 1.
struct FieldError {
  double tolerance = 5e-4;  ///< TOL
  double first = 0;         ///< w_0, of iterate 1
  double last = 0;          ///< w_K

  void begin() noexcept { first = last = 0; }
  ///   rounding  of the values themselves: a change below that tells nothing
  void measure(int iteration, double change, double moved, double rounding) noexcept {
    last = change > rounding ? change / moved : 0;
    if (iteration == 1) first = last;
  }
  [[nodiscard]] double violation() const noexcept { return last / tolerance; }
  /// Lambda_K = (TOL/w_0)^(1/(p K_d)) / (w_K/w_0)^(1/(p K)) after iterate `iteration` = K + 1; `unknown`
  /// where the iteration was too short to show a rate.
  [[nodiscard]] double factor(int iteration, int wanted, double power, double unknown) const noexcept {
    if (first == 0 || last == 0 || iteration < 2) return unknown;
    return std::pow(tolerance / first, 1 / (power * wanted)) /
           std::pow(last / first, 1 / (power * (iteration - 1)));
  }
};

}  // namespace superstep::dynamics
