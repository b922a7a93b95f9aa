#pragma once
/// Stability polynomials of order p = 2 or 4 with nearly the longest real interval:
///   R_s(z) = w(x) P_{s-p}(x),   x = 1 + 2 z / l,   z in [-l, 0]
/// w has p/2 pairs of complex roots, P_{s-p} is orthogonal with the weight w(x)^2 / sqrt(1 - x^2), both are 1
/// at x = 1. The roots' coordinates and l follow from R'(0) = ... = R^(p)(0) = 1 and |R(-l)| = 0.95 for order
/// two, 0.85 for order four, which keeps |R| at that or below 0.9 on all of the interval but its beginning.
/// Source of the construction: Abdulle & Medovikov (2001), Second order Chebyshev methods based on orthogonal
/// polynomials, doi:10.1007/s002110100292, and Abdulle (2002), Fourth order Chebyshev methods with recurrence
/// relation, doi:10.1137/S1064827500379549. Their tabulated coefficients are not used: ours are solved for
/// when first needed.

#include <array>

#include "integrators/schemes/three_term.hpp"

namespace superstep {

struct RockPolynomial {
  int order = 4;
  /// Roots of w in z: real[k] +- i imaginary[k], k < order / 2.
  std::array<double, 2> real{}, imaginary{};
  double length = 0;  ///< l, the length of the real stability interval

  /// w at z, real and normalised to w(0) = 1; coefficients of z^0 ... z^4.
  [[nodiscard]] std::array<double, 5> weight() const;
};

/// Fewest stages of a polynomial, and most: beyond, roundings would be multiplied by more than 1e-4 s^8 =
/// 1e12 in the finish of order four, by 0.2 s^4 = 3e8 in that of order two.
[[nodiscard]] constexpr int rock_fewest_stages(int order) noexcept {
  return order + 1;
}
[[nodiscard]] constexpr int rock_most_stages(int order) noexcept {
  return order == 4 ? 100 : 200;
}

/// Polynomial of this order, 2 or 4, and degree `stages`, fewest ... most. Solved for at the first call and
/// kept; calls from several threads are safe.
[[nodiscard]] const RockPolynomial& rock_polynomial(int order, int stages);

/// Sets m, n, mt of the recurrence for P_{s-p}; the arrays must have room.
void set_rock_recurrence(int stages, const RockPolynomial& polynomial, ThreeTermScheme& scheme);

}  // namespace superstep
