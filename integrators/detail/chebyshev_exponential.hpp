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
#include <vector>

namespace superstep {

/// Coefficients c_0 .. c_K with the sum of the rest below `tolerance`, scaled so that they add up to 1.
///   z [-]   t rho/2, >= 0
///   driven  sources act: a mode without decay then grows, and the rest is weighted with the k^2/z that it
///   grows by
/// Miller's backward recurrence: relative accuracy in every coefficient. O(K) time, K ~ sqrt(2 z
/// ln(1/tolerance)).
[[nodiscard]] std::vector<double> exponential_coefficients(double z, double tolerance, bool driven);

/// Integrals over time of the coefficients, in units of 2/rho: d_k = integral from 0 to z of c_k. Same
/// length.
[[nodiscard]] std::vector<double> integrated_coefficients(const std::vector<double>& c);

}  // namespace superstep
