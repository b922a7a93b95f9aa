#include "dynamics/forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/index.hpp"
#include "core/parallel.hpp"
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

}  // namespace

double damping_of(const ContactLaw& law, double push, double strain, double length, double mass) noexcept {
  if (!(law.damping > 0) || !(push > 0)) return 0;
  return normal_damping(law.damping, mass, contact_slope(push, law.exponent, -strain, length));
}

double wall_push(const Model& model, const Particles& particles, const WallContact& contact,
                 double particle_temperature) noexcept {
  const double wall_temperature = model.thermal.wall_temperature[at(contact.wall)];
  return value_of(particles.hardness, at(contact.particle), 1) *
         contact_force(model.wall, contact.strain, contact.area,
                       0.5 * (particle_temperature + wall_temperature));
}

double sum_forces(const Model& model, const Particles& particles, const ContactPoints& contacts,
                  std::span<const WallContact> walls, double upper_wall_velocity,
                  std::span<const Vec3> velocity, std::span<const double> temperature, PairDetail detail,
                  PairForces& room, std::span<Vec3> force) {
  for_each_entry(force.size(), [&](std::size_t i) {
    force[i] =
        weight(particles.mass[i], model.gravity) + drag_force(model.drag, particles.radius[i], velocity[i]);
  });
  add_pair_forces(model.contact, contacts.table(), velocity, temperature, detail, room, force,
                  [&]() -> const Incidence& { return contacts.incidence(); });
  double on_upper_wall = 0;
  for (const auto& contact : walls) {
    const std::size_t i = at(contact.particle);
    const Vec3 normal = outward(contact.wall);
    const Vec3 relative = Vec3{0, 0, contact.wall == upper ? upper_wall_velocity : 0.0} - velocity[i];
    const double push = wall_push(model, particles, contact, temperature[i]);
    const double damping =
        damping_of(model.wall, push, contact.strain, particles.radius[i], particles.mass[i]);
    force[i] = force[i] + force_through(model.wall, normal, relative, push, damping);
    if (contact.wall == upper) on_upper_wall += damped_push(push, damping, dot(relative, normal));
  }
  return on_upper_wall;
}

double explicit_step_limit(const Model& model, const Particles& particles, const ContactPoints& contacts,
                           const PairForces& pairs, std::span<const WallContact> walls,
                           std::span<const double> temperature, std::vector<double>& stiffness,
                           std::vector<double>& damping) {
  const std::size_t n = particles.size();
  stiffness.assign(n, 0.0);
  damping.assign(n, 0.0);
  const ContactTable& table = contacts.table();
  const auto add = [&](std::size_t k, double slope, double resistance) {
    for (const std::size_t p : {at(table.i[k]), at(table.j[k])}) {
      stiffness[p] += 2 * slope;
      damping[p] += 2 * resistance;
    }
  };
  for (std::size_t k = 0; k < table.size(); ++k)
    if (table.strain[k] < 0) add(k, pairs.slope[k], pairs.resistance[k]);
  const BondArrays& bonds = contacts.bonded();
  for (std::size_t b = 0; b < bonds.size(); ++b)
    add(bonds.pair[b], bonds.slope[b], table.damping[bonds.pair[b]]);
  for (const auto& contact : walls) {
    const std::size_t i = at(contact.particle);
    const double push = wall_push(model, particles, contact, temperature[i]);
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
