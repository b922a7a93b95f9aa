#pragma once
/// What the residual of a rational Krylov solution adds up to.

#include <span>

namespace superstep {

/// Bounds of an error in the capacity norm, the solution's start having length 1 there.
struct RationalError {
  double next = 0;    ///< for each unit of norm of what the last image has outside the space
  double images = 0;  ///< for each unit of Frobenius norm by which images are wrong
};

/// In an orthonormal basis V of which the images are (I + gamma A)^-1 V = V H + R, the solution of
/// y' = f_0 - A y from rest that begins with p = gamma (I + gamma A)^-1 f_0 of length 1 errs by
///   e(t) = -integral over [0, t] of (I/gamma + A) exp(-(t - s)A) R q(s) ds,
///   q(s) = H^-1 (exp(-s A_m) - s phi_1(-s A_m)/gamma) e_1,   A_m = (H^-1 - I)/gamma
/// In an eigenvector of A, with the eigenvalue lambda, that is R times a vector G(lambda) which the small
/// problem knows: the largest over all lambda >= 0 counts. It is smooth in log(lambda), varies around 1/t,
/// and is sampled there, at 0, and far beyond; a tenth is added for what may lie between.
///   pole     gamma [s]
///   rate     [m] eigenvalues of A_m [1/s];  vectors  [m * m] theirs, by columns
///   t        > 0 [s]
[[nodiscard]] RationalError rational_error(double pole, std::span<const double> rate,
                                           std::span<const double> vectors, double t);

}  // namespace superstep
