#pragma once
/// Adhesion between particles that were pressed together hard enough.

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/laws/strain_power.hpp"

namespace superstep::dynamics {

/// When a bond acts.
enum class BondRule : char {
  overlap,  ///< as printed: while |E| >= E* (in overlap only)
  tension,  ///< once |E| >= E* was reached, until the pair is torn further apart than the rupture strain
};

struct BondLaw {
  double stiffness = 0;  ///< K_b [N/m2]; 0 = there are no bonds
  double exponent = 2;   ///< p_b, >= 1
  /// E*: overlap strain at which a bond forms; the paper prints no value. Infinity = never.
  double threshold = std::numeric_limits<double>::infinity();
  BondRule rule = BondRule::overlap;
  double rupture = 0.05;  ///< tension rule: strain E > 0 at which the bond breaks

  /// Largest strain at which a bond can still act: how far the neighbour search has to see.
  [[nodiscard]] double reach() const noexcept {
    return stiffness > 0 && rule == BondRule::tension ? rupture : 0.0;
  }
};

/// Size of the attractive force K_b |E|^p_b A [N] of an acting bond. Source: Zohdi (2014), eq. 19.
///   area [m2]  of the contact; of the bond where the pair has come apart (E > 0)
[[nodiscard]] inline double bond_force(const BondLaw& law, double strain, double area) noexcept {
  return law.stiffness * strain_power(std::abs(strain), law.exponent) * area;
}

/// Area [m2] that the bond of a pair has after a step; 0 = none.
///   bonded [m2]  what it was before
///   strain, area  of the pair now; area is 0 where the pair has come apart
[[nodiscard]] inline double bond_after_step(const BondLaw& law, double bonded, double strain,
                                            double area) noexcept {
  const bool forms = -strain >= law.threshold;
  if (law.rule == BondRule::overlap) return forms ? area : 0.0;
  if (forms) return std::max(bonded, area);
  return strain > law.rupture ? 0.0 : bonded;
}

}  // namespace superstep::dynamics
