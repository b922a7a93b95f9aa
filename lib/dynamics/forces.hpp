#pragma once
/// All forces on all particles.

#include <span>
#include <vector>

#include "dynamics/contacts/contact_points.hpp"
#include "dynamics/contacts/pair_forces.hpp"
#include "dynamics/model.hpp"
#include "dynamics/particles.hpp"

namespace superstep::dynamics {

/// Where particles are in contact at one instant, and how the upper wall moves.
struct Placement {
  std::span<const ContactPoint> contacts;
  std::span<const WallContact> walls;
  double upper_wall_velocity = 0;  ///< m/s, along z
};

/// Damping coefficient of a contact that pushes with `push` [N] at this strain < 0 [kg/s].
///   length [m] that the strain refers to;  mass [kg], reduced
[[nodiscard]] double damping_of(const ContactLaw& law, double push, double strain, double length,
                                double mass) noexcept;

/// Repulsion of a wall without its damping [N], at this temperature of the particle [K].
[[nodiscard]] double wall_push(const Model& model, const Particles& particles, const WallContact& contact,
                               double temperature) noexcept;

/// Sum of the forces on each particle [N] (Zohdi 2014, eq. 21): weight, drag, contacts, bonds, walls. Returns
/// the normal force on the upper wall [N].
double sum_forces(const Model& model, const Particles& particles, const ContactPoints& contacts,
                  std::span<const WallContact> walls, double upper_wall_velocity,
                  std::span<const Vec3> velocity, std::span<const double> temperature, PairDetail detail,
                  PairForces& room, std::span<Vec3> force);

/// Longest step of a plain explicit scheme [s] by Gershgorin's bound on stiffness and damping over mass at
/// this instant; infinity where nothing acts. Oscillations limit it to 2/omega, damping to 2 m/c; both
/// together are bounded by 1/(1/h_1 + 1/h_2).
///   pairs               whole, of this instant
///   stiffness, damping  [n] scratch
[[nodiscard]] double explicit_step_limit(const Model& model, const Particles& particles,
                                         const ContactPoints& contacts, const PairForces& pairs,
                                         std::span<const WallContact> walls,
                                         std::span<const double> temperature, std::vector<double>& stiffness,
                                         std::vector<double>& damping);

}  // namespace superstep::dynamics
