#pragma once
/// Adhesion between particles that were pressed together hard enough: what all bond laws have in common.

#include <cstdint>
#include <limits>

#include "dynamics/laws/neck_growth.hpp"
#include "dynamics/laws/softening.hpp"

namespace superstep::dynamics {

/// When and how a bond acts: one file each in `bonds/`.
enum class BondRule : char {
  overlap,      ///< as printed: while |E| >= E* (in overlap only)
  tension,      ///< once |E| >= E* was reached, until the pair is torn further apart than the rupture strain
  rest_length,  ///< a neck with a length of its own, which grows
};

struct BondLaw {
  double stiffness = 0;  ///< K_b [N/m2]; 0 = there are no bonds
  double exponent = 2;   ///< p_b, >= 1; overlap and tension
  /// E*: overlap strain at which a bond forms; the paper prints no value. Infinity = never.
  double threshold = std::numeric_limits<double>::infinity();
  BondRule rule = BondRule::overlap;
  /// Tension: strain E > 0 at which the bond breaks; rest length: strain beyond its own at which it does.
  double rupture = 0.05;
  Softening softening = {};  ///< of the stiffness, K_b(T)
  double unloading = 0.02;   ///< rest length: strain below the largest overlap within which repulsion is lost
  double damping = 0;        ///< rest length: share of critical damping of the neck
  NeckGrowth growth = {};    ///< rest length

  [[nodiscard]] bool acts() const noexcept { return stiffness > 0; }
};

/// A pair at one instant, as its bond sees it.
struct BondedPair {
  double strain;        ///< E, < 0 in overlap
  double temperature;   ///< mean of the two [K]
  double pressure;      ///< of the contact, K(T) |E|^p [Pa]; 0 without overlap
  double mobility;      ///< product of the two Arrhenius roots
  double contact_area;  ///< m2; 0 without overlap
  double bond_area;     ///< of the contact at the largest overlap that the bond has seen [m2]
  double neck;          ///< part of that circle which its neck fills
  double radius_sum;    ///< m
  double reduced_mass;  ///< kg
};

/// What a bond remembers.
struct BondMemory {
  double overlap = 0;  ///< largest -E since it formed
  double growth = 0;   ///< u of its neck
};

/// What a bond does at one instant.
struct BondAction {
  double keep = 1;     ///< part of the contact's repulsion, damping and friction that is left
  double pull = 0;     ///< attraction [N]
  double damping = 0;  ///< of the normal motion [kg/s]
  double area = 0;     ///< through which heat and current flow [m2]
  double slope = 0;    ///< bound of what the bond adds to the slope of the force [N/m]
};

}  // namespace superstep::dynamics
