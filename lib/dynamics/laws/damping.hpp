#pragma once
/// Optional damping of the normal motion in a contact; the source paper has none.

#include <algorithm>
#include <cmath>

namespace superstep::dynamics {

/// Slope of the contact force with the overlap [N/m]: F ~ |E|^p A and A ~ |E| for small overlaps, so the
/// slope is (p + 1) F/(|E| L). F [N] >= 0, |E| > 0, L [m] the length that the strain refers to.
[[nodiscard]] inline double contact_slope(double force, double exponent, double strain,
                                          double length) noexcept {
  return (exponent + 1) * force / (strain * length);
}

/// Damping coefficient 2 zeta sqrt(m k) [kg/s] for reduced mass m [kg] and slope k [N/m]: zeta is the share
/// of critical damping at the present overlap. It vanishes with the overlap, so the force has no jump at
/// touch.
[[nodiscard]] inline double normal_damping(double share, double mass, double slope) noexcept {
  return 2 * share * std::sqrt(mass * slope);
}

/// Repulsion [N] with its damping: a contact never pulls, however fast the bodies move apart.
///   parting [m/s]  speed at which they do, < 0 while they approach
[[nodiscard]] inline double damped_push(double push, double damping, double parting) noexcept {
  return std::max(push - damping * parting, 0.0);
}

}  // namespace superstep::dynamics
