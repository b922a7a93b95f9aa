#pragma once
/// Repulsion between particles that overlap.
///
///        |<-- distance -->|          strain E = (distance - (r_i + r_j))/(r_i + r_j)  < 0 in contact
///      ( i      (|)      j )         contact circle of radius a: a^2 = r_i^2 - L_i^2
///        |<-L_i->|

#include <algorithm>
#include <numbers>

#include "dynamics/laws/softening.hpp"
#include "dynamics/laws/strain_power.hpp"

namespace superstep::dynamics {

/// Parameters of one kind of contact: particle to particle, or particle to wall.
struct ContactLaw {
  double stiffness = 0;  ///< K_0 [N/m2], >= 0
  double exponent = 2;   ///< p, >= 1
  Softening softening;   ///< of the stiffness
  double friction = 0;   ///< mu_d, >= 0
  double friction_speed =
      0.01;            ///< sliding speed [m/s] at which friction reaches 71 % of its full value; > 0
  double damping = 0;  ///< share of critical normal damping, >= 0; 0 = none, as printed
};

/// Strain of a pair: negative where the spheres overlap. Source: Zohdi (2014), eq. 3.
[[nodiscard]] constexpr double pair_strain(double distance, double radius_sum) noexcept {
  return (distance - radius_sum) / radius_sum;
}

/// Area of the circle in which two spheres of squared radii [m2] intersect [m2]. Source: Zohdi (2014), eqs
/// 7-12. Once its plane has passed the centre of the smaller sphere the circle would shrink again; the area
/// then stays pi r^2 of that sphere, so that the force does not let go.
[[nodiscard]] inline double circle_area(double distance, double square_i, double square_j) noexcept {
  const double to_plane = 0.5 * (distance - (square_j - square_i) / distance);
  const double inside = std::max(square_i - to_plane * to_plane, 0.0);  // choices, no branches: see bonds
  return std::numbers::pi * (to_plane <= 0 ? square_i : to_plane >= distance ? square_j : inside);
}
/// The same of radii.
[[nodiscard]] inline double pair_area(double distance, double r_i, double r_j) noexcept {
  return circle_area(distance, r_i * r_i, r_j * r_j);
}

/// Size of the repulsive force K(T) |E|^p A [N]; E < 0, T = mean of the pair [K].
/// Source: Zohdi (2014), eqs 2 and 13.
[[nodiscard]] inline double contact_force(const ContactLaw& law, double strain, double area,
                                          double temperature) noexcept {
  return softened(law.stiffness, law.softening, temperature) * strain_power(-strain, law.exponent) * area;
}

}  // namespace superstep::dynamics
