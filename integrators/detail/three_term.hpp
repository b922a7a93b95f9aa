#pragma once
/// Stabilised explicit methods as one three-term recurrence, each stage one fused sweep:
///   Y_0 = y_n;  Y_1 = Y_0 + mt_1 h F_0
///   Y_j = (1 - m_j - n_j) Y_0 + m_j Y_{j-1} + n_j Y_{j-2} + mt_j h F_{j-1} + gt_j h F_0

#include <span>
#include <vector>

#include "rhs/rhs.hpp"

namespace superstep {

/// Coefficients of one method with s stages; entry 0 of each array is unused.
struct ThreeTermScheme {
  int stages = 0;
  double beta = 0;                      ///< stable for h * rho <= beta
  bool uses_first_derivative = false;   ///< gt or the Y_0 term is not zero
  std::vector<double> m, n, mt, gt, c;  ///< [s+1]; c_j h = time of stage j
};

/// First-order RKC polynomial T_s(w0 + w1 z)/T_s(w0), by ratios of T_j that cannot overflow.
///   excess [-]  w0 - 1 > 0, given as such because 1 + excess would lose its digits
/// Super-time-stepping with damping nu is the case w0 = (1 + nu)/(1 - nu), excess = 2 nu/(1 - nu).
/// Source: Verwer, Hundsdorfer & Sommeijer (1990), Convergence properties of the Runge-Kutta-Chebyshev
/// method.
void first_order_chebyshev(int stages, double excess, ThreeTermScheme& scheme);

/// Work vectors of the recurrence, allocated once.
class ThreeTermEngine {
 public:
  void resize(std::size_t size);
  /// One step from y0 over h. `f0` = f(t, y0) when the scheme uses it, else may be empty (the engine sweeps
  /// for itself).
  ///   inflow  when not null, gains the inflow integrated by the same recurrence
  /// The result is in `result()` until the next call; y0 is left as it is.
  void step(Rhs& rhs, const ThreeTermScheme& scheme, double t, double h, std::span<const double> y0,
            std::span<const double> f0, double* inflow);
  [[nodiscard]] std::vector<double>& result() noexcept { return result_; }

 private:
  std::vector<double> result_, previous_;
};

}  // namespace superstep
