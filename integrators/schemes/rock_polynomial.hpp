#pragma once
/// Stability polynomials of order four with nearly the longest real interval:
///   R_s(z) = w(x) P_{s-4}(x),   x = 1 + 2 z / l,   z in [-l, 0]
/// w has two pairs of complex roots, P_{s-4} is orthogonal with the weight w(x)^2 / sqrt(1 - x^2), both are 1
/// at x = 1. Four roots' coordinates and l follow from R'(0) = ... = R''''(0) = 1 and |R(-l)| = 0.85, which
/// keeps |R| below 0.9 on all of the interval but its beginning.
/// Source of the construction: Abdulle (2002), Fourth order Chebyshev methods with recurrence relation,
/// doi:10.1137/S1064827500379549. Its tabulated coefficients are not used: ours are solved for when first
/// needed.

#include <array>

#include "integrators/schemes/three_term.hpp"

namespace superstep {

constexpr int rock_fewest_stages = 5, rock_most_stages = 100;

struct RockPolynomial {
  /// Roots of w in z: real[k] +- i imaginary[k].
  std::array<double, 2> real{}, imaginary{};
  double length = 0;  ///< l, the length of the real stability interval

  /// w at z, real and normalised to w(0) = 1; coefficients of z^0 ... z^4.
  [[nodiscard]] std::array<double, 5> weight() const;
};

/// Polynomial of degree `stages` (fewest ... most; beyond, the finish would multiply roundings by more than
/// 1e-4 s^8 = 1e12). Solved for at the first call and kept; calls from several threads are safe.
[[nodiscard]] const RockPolynomial& rock_polynomial(int stages);

/// Sets m, n, mt of the recurrence for P_{s-4}; the arrays must have room.
void set_rock_recurrence(int stages, const RockPolynomial& polynomial, ThreeTermScheme& scheme);

}  // namespace superstep
