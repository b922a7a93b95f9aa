#pragma once
/// How the neck between two pressed particles grows with temperature and time.
///
/// The neck of radius x fills a part s = (x/a)^2 of the contact circle of radius a. Alone, it grows as
///   (x/a)^n = integral of k dt,   n = 2: viscous flow (Frenkel 1945),   n = 6: diffusion along the grain
///                                 boundary (Coble 1958, doi:10.1111/j.1151-2916.1958.tb13519.x),
/// and it ends at the circle that it grows into: u = (x/a)^n obeys du/dt = k (1 - u). The rate is
///   k = k_ref exp(-Q/R (1/T - 1/T_ref)) (1 + p/p_s):
/// Arrhenius in T, the harmonic mean of the two temperatures; pressure p drives it beside the sintering
/// stress p_s of the neck's own curvature (Coble 1970, hot pressing, doi:10.1063/1.1658543). Frenkel's law
/// with its end: Pokluda, Bellehumeur & Vlachopoulos (1997), doi:10.1002/aic.690431213; the exponential end
/// is ours.

#include <algorithm>
#include <cmath>
#include <limits>

namespace superstep::dynamics {

inline constexpr double gas_constant = 8.31446261815324;  ///< R [J/(mol K)]

struct NeckGrowth {
  enum class Mechanism : char { frenkel, coble };
  Mechanism mechanism = Mechanism::frenkel;
  double rate = 0;          ///< k_ref [1/s] at the reference temperature, >= 0
  double activation = 0;    ///< Q [J/mol], >= 0
  double reference = 1000;  ///< T_ref [K], > 0
  double sintering_stress =
      std::numeric_limits<double>::infinity();  ///< p_s [Pa]; infinity = pressure does not help
};

/// The part of one particle of temperature T in the Arrhenius factor: the pair's is the product of two.
[[nodiscard]] inline double arrhenius_root(const NeckGrowth& law, double temperature) noexcept {
  if (law.activation == 0) return 1;
  return std::exp(-0.5 * law.activation / gas_constant * (1 / temperature - 1 / law.reference));
}

/// Rate k [1/s] under the pressure p [Pa] >= 0 of the contact.
[[nodiscard]] inline double growth_rate(const NeckGrowth& law, double mobility, double pressure) noexcept {
  return law.rate * mobility * (1 + pressure / law.sintering_stress);
}

/// u at the end of a step of h [s] by the phi rule, linear in u and thus solved at once.
[[nodiscard]] inline double grown(double u, double rate_begin, double rate_end, double h,
                                  double phi) noexcept {
  const double end = phi * h * rate_end;
  return std::min((u + (1 - phi) * h * rate_begin * (1 - u) + end) / (1 + end), 1.0);
}

/// Part s of the contact circle that the neck fills. A grain boundary neck has (x/a)^2 = u^(1/3), which
/// begins with infinite slope; it is taken from the size on that ten percent of the radius have, u = 1e-6,
/// moved to 0.
[[nodiscard]] inline double neck_part(const NeckGrowth& law, double u) noexcept {
  if (law.mechanism == NeckGrowth::Mechanism::frenkel) return u;
  constexpr double begin = 1e-6, root = 1e-2;  // its cube root
  return (std::cbrt(u + begin) - root) / (std::cbrt(1 + begin) - root);
}

}  // namespace superstep::dynamics
