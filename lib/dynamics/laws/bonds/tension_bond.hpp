#pragma once
/// The printed force K_b |E|^p_b A, but once a pair has been pressed to |E| >= E* the bond acts at any
/// strain, in tension too (there with the largest area that the contact had), until the pair is torn apart by
/// the rupture strain. Its force jumps where it forms and where it breaks.

#include <cmath>

#include "dynamics/laws/bond_law.hpp"
#include "dynamics/laws/strain_power.hpp"

namespace superstep::dynamics {

struct TensionBond {
  static constexpr const char* name = "tension";
  static constexpr bool smooth = false;
  static constexpr bool grows = false;

  [[nodiscard]] static double margin(const BondLaw& law, double strain, BondMemory, bool bonded) noexcept {
    return bonded ? law.rupture - strain : law.threshold + strain;
  }
  [[nodiscard]] static double rate(const BondLaw&, const BondedPair&, BondMemory) noexcept { return 0; }
  [[nodiscard]] static BondAction act(const BondLaw& law, const BondedPair& pair, BondMemory) noexcept {
    const double area = pair.strain < 0 ? pair.contact_area : pair.bond_area;
    const double strain = std::abs(pair.strain);
    const double pull =
        softened(law.stiffness, law.softening, pair.temperature) * strain_power(strain, law.exponent) * area;
    return {.pull = pull,
            .area = pair.bond_area,  // the neck stays, so that nothing jumps when the pair comes apart
            .slope = strain > 0 ? (law.exponent + 1) * pull / (strain * pair.radius_sum) : 0};
  }
};

}  // namespace superstep::dynamics
