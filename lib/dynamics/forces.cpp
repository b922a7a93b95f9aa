#include "dynamics/forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/index.hpp"
#include "dynamics/laws/damping.hpp"
#include "dynamics/laws/drag.hpp"
#include "dynamics/laws/friction.hpp"
#include "dynamics/laws/gravity.hpp"

namespace superstep::dynamics {
namespace {

/// Force on this body from the other one through a contact.
///   normal    from this body to the other
///   relative  v_other - v_this [m/s]
///   push      size of the repulsive force [N]
///   damping   normal damping coefficient [kg/s]
Vec3 force_through(const ContactLaw& law, Vec3 normal, Vec3 relative, double push, double damping) noexcept {
  const double parting = dot(relative, normal);  // > 0 while the bodies move apart
  Vec3 force = -damped_push(push, damping, parting) * normal;
  if (law.friction > 0) {
    const Vec3 slip = relative - parting * normal;
    force = force + push * friction_direction(law.friction, slip, law.friction_speed);
  }
  return force;
}

double damping_of(const ContactLaw& law, double push, double strain, double length, double mass) noexcept {
  if (!(law.damping > 0)) return 0;
  return normal_damping(law.damping, mass, contact_slope(push, law.exponent, -strain, length));
}

double reduced_mass(double m_i, double m_j) noexcept {
  return m_i * m_j / (m_i + m_j);
}

Vec3 pair_force(const Model& model, const Particles& particles, const ContactPoint& contact,
                std::span<const Vec3> velocity, std::span<const double> temperature) noexcept {
  const std::size_t i = at(contact.i), j = at(contact.j);
  Vec3 force;
  if (contact.strain < 0) {
    const ContactLaw& law = model.contact;
    const double push =
        contact_force(law, contact.strain, contact.area, 0.5 * (temperature[i] + temperature[j]));
    const double damping = damping_of(law, push, contact.strain, contact.radius_sum,
                                      reduced_mass(particles.mass[i], particles.mass[j]));
    force = force_through(law, contact.normal, velocity[j] - velocity[i], push, damping);
  }
  if (contact.bonded) force = force + bond_force(model.bond, contact.strain, contact.area) * contact.normal;
  // Centres that coincide have no direction: NaN, so that the step is refused and the pair named.
  return contact.distance > 0 ? force : std::numeric_limits<double>::quiet_NaN() * Vec3{1, 1, 1};
}

double wall_push(const Model& model, const WallContact& contact, double particle_temperature) noexcept {
  const double wall_temperature = model.thermal.wall_temperature[at(contact.wall)];
  return contact_force(model.wall, contact.strain, contact.area,
                       0.5 * (particle_temperature + wall_temperature));
}

Vec3 wall_velocity(const Placement& placement, Wall wall) noexcept {
  return {0, 0, wall == upper ? placement.upper_wall_velocity : 0.0};
}

}  // namespace

double sum_forces(const Model& model, const Particles& particles, const Placement& placement,
                  std::span<const Vec3> velocity, std::span<const double> temperature,
                  std::span<Vec3> force) {
  for (std::size_t i = 0; i < force.size(); ++i)
    force[i] =
        weight(particles.mass[i], model.gravity) + drag_force(model.drag, particles.radius[i], velocity[i]);
  for (const auto& contact : placement.contacts) {
    const Vec3 pair = pair_force(model, particles, contact, velocity, temperature);
    force[at(contact.i)] = force[at(contact.i)] + pair;
    force[at(contact.j)] = force[at(contact.j)] - pair;
  }
  double on_upper_wall = 0;
  for (const auto& contact : placement.walls) {
    const std::size_t i = at(contact.particle);
    const Vec3 normal = outward(contact.wall);
    const double push = wall_push(model, contact, temperature[i]);
    const double damping =
        damping_of(model.wall, push, contact.strain, particles.radius[i], particles.mass[i]);
    const Vec3 relative = wall_velocity(placement, contact.wall) - velocity[i];
    force[i] = force[i] + force_through(model.wall, normal, relative, push, damping);
    if (contact.wall == upper) on_upper_wall += damped_push(push, damping, dot(relative, normal));
  }
  return on_upper_wall;
}

double explicit_step_limit(const Model& model, const Particles& particles, const Placement& placement,
                           std::span<const double> temperature, std::vector<double>& stiffness,
                           std::vector<double>& damping) {
  const std::size_t n = particles.size();
  stiffness.assign(n, 0.0);
  damping.assign(n, 0.0);
  for (const auto& contact : placement.contacts) {
    const std::size_t i = at(contact.i), j = at(contact.j);
    double slope = 0, resistance = 0;
    if (contact.strain < 0) {
      const double push =
          contact_force(model.contact, contact.strain, contact.area, 0.5 * (temperature[i] + temperature[j]));
      slope = contact_slope(push, model.contact.exponent, -contact.strain, contact.radius_sum);
      resistance = damping_of(model.contact, push, contact.strain, contact.radius_sum,
                              reduced_mass(particles.mass[i], particles.mass[j])) +
                   model.contact.friction * push / model.contact.friction_speed;
    }
    if (contact.bonded && contact.strain != 0)
      slope += contact_slope(bond_force(model.bond, contact.strain, contact.area), model.bond.exponent,
                             std::abs(contact.strain), contact.radius_sum);
    for (const std::size_t k : {i, j}) {
      stiffness[k] += 2 * slope;
      damping[k] += 2 * resistance;
    }
  }
  for (const auto& contact : placement.walls) {
    const std::size_t i = at(contact.particle);
    const double push = wall_push(model, contact, temperature[i]);
    stiffness[i] += contact_slope(push, model.wall.exponent, -contact.strain, particles.radius[i]);
    damping[i] += damping_of(model.wall, push, contact.strain, particles.radius[i], particles.mass[i]) +
                  model.wall.friction * push / model.wall.friction_speed;
  }
  double inverse = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double drag =
        -drag_force(model.drag, particles.radius[i], model.drag.medium_velocity + Vec3{1, 0, 0}).x;
    inverse = std::max(inverse, std::sqrt(stiffness[i] / particles.mass[i]) / 2 +
                                    (damping[i] + drag) / (2 * particles.mass[i]));
  }
  return inverse > 0 ? 1 / inverse : std::numeric_limits<double>::infinity();
}

}  // namespace superstep::dynamics
