#include "dynamics/powers.hpp"

#include <algorithm>
#include <cmath>

#include "core/index.hpp"
#include "dynamics/laws/damping.hpp"
#include "dynamics/laws/drag.hpp"
#include "dynamics/laws/friction.hpp"
#include "dynamics/laws/gravity.hpp"

namespace superstep::dynamics {
namespace {

/// What a contact does while its bodies part at `parting` [m/s] and slide at `slip`.
///   push       repulsion without damping [N]; `keep` of it is left
///   pull       attraction [N]
struct Through {
  const ContactLaw& law;
  double push, keep, pull, bond_damping;

  void add(double parting, Vec3 slip, double damping, Powers& out) const noexcept {
    const double damped = damped_push(push, damping, parting);
    // Parting bodies do work against the pull and receive that of the repulsion.
    out.elastic += (pull - keep * push) * parting;
    out.dissipated += (keep * (push - damped) + bond_damping * parting) * parting;
    if (law.friction > 0)
      out.dissipated += keep * push * dot(friction_direction(law.friction, slip, law.friction_speed), slip);
  }
};

void add_pairs(const MovingNetwork& network, std::span<const Vec3> velocity,
               std::span<const double> temperature, Powers& out) {
  const ContactTable& table = network.contacts().table();
  const ContactLaw& law = network.model().contact;
  const auto held = network.held();
  for (std::size_t k = 0; k < table.size(); ++k) {
    if (table.area[k] == 0 && table.flow[k] == 0) continue;
    const std::size_t i = at(table.i[k]), j = at(table.j[k]);
    const Vec3 normal{table.nx[k], table.ny[k], table.nz[k]}, relative = velocity[j] - velocity[i];
    const double parting = dot(relative, normal), strain = std::min(table.strain[k], 0.0);
    const double push = table.hardness[k] *
                        contact_force(law, strain, table.area[k], 0.5 * (temperature[i] + temperature[j]));
    const Through through{law, push, table.keep[k], table.pull[k], table.damping[k]};
    through.add(parting, relative - parting * normal,
                damping_of(law, push, strain, table.radius_sum[k], table.reduced_mass[k]), out);
    if ((held[i] >= 0) == (held[j] >= 0)) continue;
    const double flow = table.conductivity[k] * table.flow[k] * (temperature[i] - temperature[j]);
    out.heat_lost += held[j] >= 0 ? flow : -flow;
  }
}

void add_walls(const MovingNetwork& network, std::span<const Vec3> velocity,
               std::span<const double> temperature, Powers& out) {
  const Model& model = network.model();
  const Particles& particles = network.particles();
  const Placement placement = network.placement();
  const auto held = network.held();
  for (const auto& contact : placement.walls) {
    const std::size_t i = at(contact.particle);
    const Vec3 normal = outward(contact.wall);
    const Vec3 wall{0, 0, contact.wall == upper ? placement.upper_wall_velocity : 0.0};
    const Vec3 relative = wall - velocity[i];
    const double parting = dot(relative, normal);
    const double push = wall_push(model, particles, contact, temperature[i]);
    const double damping =
        damping_of(model.wall, push, contact.strain, particles.radius[i], particles.mass[i]);
    Through{model.wall, push, 1, 0, 0}.add(parting, relative - parting * normal, damping, out);
    // The wall pushes the particle inwards and moves along its own normal: friction does no work on it.
    out.wall -= damped_push(push, damping, parting) * dot(wall, normal);
    if (model.thermal.walls_conduct && held[i] < 0)
      out.heat_lost += wall_conductance(model.thermal, particles, contact) *
                       (temperature[i] - model.thermal.wall_temperature[at(contact.wall)]);
  }
}

}  // namespace

Powers powers_of(const MovingNetwork& network, std::span<const Vec3> velocity,
                 std::span<const double> temperature) {
  Powers out;
  const Model& model = network.model();
  const Particles& particles = network.particles();
  const auto held = network.held();
  const auto joule = network.current().heat();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    out.weight += dot(weight(particles.mass[i], model.gravity), velocity[i]);
    out.dissipated -= dot(drag_force(model.drag, particles.radius[i], velocity[i]), velocity[i]);
    if (held[i] < 0) out.joule += joule[i];
  }
  add_pairs(network, velocity, temperature, out);
  add_walls(network, velocity, temperature, out);
  return out;
}

}  // namespace superstep::dynamics
