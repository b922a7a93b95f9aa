#pragma once
/// Chebyshev coefficients of what a linear network makes of its state and of a source over one panel of time:
///   y(h) = exp(-h A) y(0) + integral_0^h exp(-(h-s) A) q(s) ds,  q(s) = sum_p r_p T_p(2 s/h - 1)
/// so that y(h) = sum_k T_k(1 - 2 A/rho) [ c_k y(0) + sum_p g_pk r_p ]. Every function of A on the right is a
/// function of one variable, sampled at Chebyshev points and transformed. The same for the integral of y over
/// the panel.
/// Source of the variation-of-constants form: Hochbruck & Ostermann (2010), doi:10.1017/S0962492910000048.

#include <cstddef>
#include <vector>

namespace superstep {

/// Coefficients of y(h), or of the integral of y over the panel.
struct DuhamelCoefficients {
  std::vector<double> state;                ///< [terms] of y(0)
  std::vector<std::vector<double>> source;  ///< [degree+1][terms] of r_p
};

struct DuhamelPanel {
  double h = 0;    ///< s, length of the panel
  double rho = 0;  ///< 1/s, the spectrum of A lies in [0, rho]
  int degree = 0;  ///< of q in time
};

/// At least so many terms leave the rest of the expansion below `tolerance`.
[[nodiscard]] std::size_t duhamel_terms(const DuhamelPanel& panel, double tolerance);
[[nodiscard]] DuhamelCoefficients end_coefficients(const DuhamelPanel& panel, std::size_t terms);
[[nodiscard]] DuhamelCoefficients integral_coefficients(const DuhamelPanel& panel, std::size_t terms);

/// gamma_p(mu) = integral_0^1 exp(-mu w) T_p(1 - 2 w) dw for p = 0 ... degree, mu >= 0.
[[nodiscard]] std::vector<double> exponential_moments(double mu, int degree);
/// Integrals of T_p(2 u - 1) over [0, 1] for p = 0 ... degree.
[[nodiscard]] std::vector<double> chebyshev_integrals(int degree);

}  // namespace superstep
