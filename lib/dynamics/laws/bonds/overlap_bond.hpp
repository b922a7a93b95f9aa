#pragma once
/// The printed bond: K_b |E|^p_b A, attractive, while |E| >= E*. Source: Zohdi (2014), eq. 19.
/// With E < 0 in overlap alone it never holds anything in tension: it weakens the contact. Its force jumps at
/// E*.

#include <cmath>

#include "dynamics/laws/bond_law.hpp"
#include "dynamics/laws/strain_power.hpp"

namespace superstep::dynamics {

struct OverlapBond {
  static constexpr const char* name = "overlap";
  static constexpr bool smooth = false;
  static constexpr bool grows = false;

  [[nodiscard]] static double margin(const BondLaw& law, double strain, BondMemory, bool bonded) noexcept {
    const double beyond = -strain - law.threshold;
    return bonded ? beyond : -beyond;
  }
  [[nodiscard]] static double rate(const BondLaw&, const BondedPair&, BondMemory) noexcept { return 0; }
  [[nodiscard]] static BondAction act(const BondLaw& law, const BondedPair& pair, BondMemory) noexcept {
    const double overlap = std::max(-pair.strain, 0.0);
    const double pull = softened(law.stiffness, law.softening, pair.temperature) *
                        strain_power(overlap, law.exponent) * pair.contact_area;
    return {.pull = pull,
            .area = pair.contact_area,
            .slope = overlap > 0 ? (law.exponent + 1) * pull / (overlap * pair.radius_sum) : 0};
  }
};

}  // namespace superstep::dynamics
