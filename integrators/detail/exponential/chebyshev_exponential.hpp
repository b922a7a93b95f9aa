#pragma once
/// Coefficients of exp(-t A) in Chebyshev polynomials, A with spectrum in [0, rho]:
///   exp(-t lambda) = sum_k c_k(t) T_k(1 - 2 lambda/rho),  c_0 = e^-z I_0(z), c_k = 2 e^-z I_k(z), z = t
///   rho/2
///
/// For dX/dt = f(X) = b - A X the vectors U_0 = X_0, U_1 = U_0 + (2/rho) f(U_0),
/// U_{k+1} = 2 U_k - U_{k-1} + (4/rho) f(U_k) are X_s + T_k (X_0 - X_s), whether or not a steady state X_s
/// exists in closed form, and since the c_k add up to 1, X(t) = sum_k c_k(t) U_k: one fused sweep a term,
/// sources included. Source: Tal-Ezer (1986), doi:10.1137/0723001, for the expansion; the affine form is our
/// own.

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "core/state_vector.hpp"
#include "rhs/rhs.hpp"

namespace superstep {

/// What the terms that an expansion leaves out are multiplied with, in spans of the field. Since coefficients
/// add up to 1, U_k may be counted from anything; two choices, and what leaves out less is taken.
///
/// From U_0: without inputs all U_k lie within a span of it. With them X(t) = X_0 + t phi_1 f_0 + t^2 phi_2
/// f', and since |T_k(x) - 1| <= k^2 (1 - x), |T_k(x) - 1 + k^2 (1 - x)| <= k^4 (1 - x)^2 / 6, the terms k of
/// the rest count as k^2/z (t |f_0|) and (k^2/z)^2/6 (t^2 |f'|): bounds for every spectrum within [0, rho].
///
/// From a uniform state: what X_0 deviates from it by does not grow, since |T_k(x)| <= 1; f is that of the
/// uniform state, 0 where nothing but the nodes exchange with each other.
struct ExpansionScale {
  bool by_rate = false;  ///< inputs act
  double rate = 0;       ///< |f_0| over the span [1/s], or once multiplied with the time [-]
  double turn = 0;       ///< |f'| over the span [1/s2], or [-]
  /// Of the initial state from a uniform one [-], and the rate of that one; the largest number = not known.
  double deviation = std::numeric_limits<double>::max(), uniform_rate = 0;
  [[nodiscard]] ExpansionScale over(double t) const noexcept {
    return {by_rate, rate * t, turn * t * t, deviation, uniform_rate * t};
  }
};

/// That of a linear field over `elapsed` from (t, y), on one piece of its inputs: up to three sweeps.
///   span  of the field [K or V];  work, more_work  written over
[[nodiscard]] ExpansionScale find_expansion_scale(Rhs& rhs, double t, double elapsed,
                                                  std::span<const double> y, double span, StateVector& work,
                                                  StateVector& more_work);

struct TruncatedSeries {
  std::vector<double> c;  ///< c_0 .. c_K, scaled so that they add up to 1
  double left_out = 0;    ///< bound of what the rest would have contributed, in spans
};

/// Coefficients with what the rest can contribute below `tolerance` (in spans).
///   z [-]   t rho/2, >= 0
/// Miller's backward recurrence: relative accuracy in every coefficient. O(K) time, K ~ sqrt(2 z
/// ln(1/tolerance)).
[[nodiscard]] TruncatedSeries exponential_series(double z, double tolerance,
                                                 const ExpansionScale& scale = {});

/// Integrals over time of the coefficients, in units of 2/rho: d_k = integral from 0 to z of c_k. Same
/// length.
[[nodiscard]] std::vector<double> integrated_coefficients(const std::vector<double>& c);

}  // namespace superstep
