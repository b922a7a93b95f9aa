#pragma once
/// Coefficients of the stabilised families on the three-term engine, and the smallest stage count for a step.

#include <string>

#include "integrators/schemes/three_term.hpp"

namespace superstep {

/// A family of three-term methods, one scheme per stage count.
struct StabilisedFamily {
  std::string name;
  int order = 2;  ///< of the method
  int fewest_stages = 2;
  int stage_step = 1;                                            ///< 2 = odd stage counts only
  double (*beta)(int stages) = nullptr;                          ///< length of the real stability interval
  void (*build)(int stages, ThreeTermScheme& scheme) = nullptr;  ///< reuses the memory of `scheme`
  int most_stages = 20000;                                       ///< beyond, beta is good for counting only
  int controlled_order = order;                                  ///< of the result whose error is estimated
  /// A rounding inside a step with s stages reaches its end multiplied by up to factor s^power.
  double rounding_factor = 1;
  int rounding_power = 2;
  /// Those of the recurrence at the stiffest mode are multiplied by stiff_end s^power behind it; such a
  /// family's schemes work by change.
  double stiff_end = 0;

  /// Smallest allowed stage count with beta(s) >= z.
  [[nodiscard]] int stages_for(double z) const;
  [[nodiscard]] ThreeTermScheme scheme(int stages) const;
  /// Most stages with which a step's roundings stay a tenth of the relative tolerance `rtol`.
  [[nodiscard]] int stages_within_rounding(double rtol) const;
};

/// RKC1 and RKC2: Sommeijer, Shampine & Verwer (1998), doi:10.1016/S0377-0427(97)00219-7.
[[nodiscard]] const StabilisedFamily& rkc1_family();
[[nodiscard]] const StabilisedFamily& rkc2_family();
/// RKL1 and RKL2: Meyer, Balsara & Aslam (2014), doi:10.1016/j.jcp.2013.08.021.
[[nodiscard]] const StabilisedFamily& rkl1_family();
[[nodiscard]] const StabilisedFamily& rkl2_family();
/// RKG2: Skaras, Saxton, Meyer & Aslam (2021), doi:10.1016/j.jcp.2020.109879.
[[nodiscard]] const StabilisedFamily& rkg2_family();

/// Orthogonal Chebyshev polynomials. ROCK2: Abdulle & Medovikov (2001), doi:10.1007/s002110100292; ROCK4:
/// Abdulle (2002), doi:10.1137/S1064827500379549.
[[nodiscard]] const StabilisedFamily& rock2_family();
[[nodiscard]] const StabilisedFamily& rock4_family();

/// Stability polynomial R(z) of a scheme by its own recurrence, and its Taylor coefficient c_k of z^k at 0.
[[nodiscard]] double stability_polynomial(const ThreeTermScheme& scheme, double z);
[[nodiscard]] double taylor_coefficient(const ThreeTermScheme& scheme, int k);

}  // namespace superstep
