#pragma once
/// One definition per file neck_NAME.cpp; `neck.cpp` lists them.

#include "contact/neck.hpp"

namespace superstep {

/// Harmonic mean of the radii, 2 r_i r_j/(r_i + r_j) [m]. Source: Rojek & Nisar (2026), eq. 35.
[[nodiscard]] constexpr double effective_radius(double r_i, double r_j) noexcept {
  return 2.0 * r_i * r_j / (r_i + r_j);
}

/// Radius of the circle in which two spheres intersect.
[[nodiscard]] NeckLaw neck_geometric();
/// Elastic spheres pressed together.
[[nodiscard]] NeckLaw neck_hertz();
/// Strain-hardening to perfectly plastic spheres pressed together.
[[nodiscard]] NeckLaw neck_plastic();
/// Two-particle sintering: the lens of the intersection moves into the neck.
[[nodiscard]] NeckLaw neck_coble();
/// Coble's neck with the volume of both spheres kept exactly.
[[nodiscard]] NeckLaw neck_volume_preserving();

/// Overlap [m] at which the volume-preserving neck reaches the smaller radius.
[[nodiscard]] double saturation_overlap(double r_i, double r_j) noexcept;

}  // namespace superstep
