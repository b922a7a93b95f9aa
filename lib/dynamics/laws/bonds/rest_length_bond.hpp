#pragma once
/// A neck that has grown at the largest overlap e_m of its contact and keeps that length.
///
///   force                         x = e_m - e: how far the pair has come apart since, e = -E
///   ^ loading: the contact's      b(x): 0 -> 1 over the unloading strain      (a smooth step)
///   |        .'                   c(x): 1 -> 0 from half the rupture strain on (another one)
///   |      .' |                   s: part of the contact circle that the neck fills
///   |   .-'  /                    repulsion that is left   1 - s b c   of the contact's
///   +-------/------> e            pull                     s b c K_b(T) x A_m
///          / e_m
///
/// A hot pressed contact flows and has no elastic strain to give back: below e_m its repulsion goes, as in an
/// elastic-plastic contact that is unloaded, and the neck pulls the pair back to e_m, where pull and slope
/// are 0. Forces are continuously differentiable in time where bonds form, are unloaded, loaded again, and
/// break; the pull is bounded and never draws a pair further than to e_m. The neck grows (`neck_growth.hpp`)
/// while it is pressed, from E* on: what would grow later grows free of stress at another length, and is left
/// out. Until it is torn (x = rupture) its area conducts heat and current.

#include <cmath>

#include "dynamics/laws/bond_law.hpp"
#include "dynamics/laws/smooth_step.hpp"

namespace superstep::dynamics {

struct RestLengthBond {
  static constexpr const char* name = "rest-length";
  static constexpr bool smooth = true;
  static constexpr bool grows = true;

  [[nodiscard]] static double margin(const BondLaw& law, double strain, BondMemory memory,
                                     bool bonded) noexcept {
    return bonded ? law.rupture - (memory.overlap + strain) : law.threshold + strain;
  }
  [[nodiscard]] static double rate(const BondLaw& law, const BondedPair& pair, BondMemory memory) noexcept {
    const double overlap = -pair.strain;
    const double pressed = smooth_step(2 * (overlap / law.threshold - 1)) *
                           (1 - smooth_step((memory.overlap - overlap) / law.unloading));
    return pressed * growth_rate(law.growth, pair.mobility, pair.pressure);
  }
  [[nodiscard]] static BondAction act(const BondLaw& law, const BondedPair& pair,
                                      BondMemory memory) noexcept {
    const double apart = std::max(memory.overlap + pair.strain, 0.0);
    const double whole = 1 - smooth_step(2 * apart / law.rupture - 1);
    const double neck = pair.neck * whole;
    const double free = neck * smooth_step(apart / law.unloading);
    const double stiffness = softened(law.stiffness, law.softening, pair.temperature) * pair.bond_area;
    constexpr double steepest = 1.5;  // slope of a smooth step
    const double slope = neck * stiffness / pair.radius_sum;
    return {.keep = 1 - free,
            .pull = free * stiffness * apart,
            .damping = 2 * law.damping * neck * std::sqrt(pair.reduced_mass * stiffness / pair.radius_sum),
            .area = pair.contact_area + neck * std::max(pair.bond_area - pair.contact_area, 0.0),
            .slope = slope +
                     neck * steepest * pair.pressure * pair.contact_area / (law.unloading * pair.radius_sum)};
  }
};

}  // namespace superstep::dynamics
