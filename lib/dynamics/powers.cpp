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

void add_pairs(const MovingNetwork& network, std::span<const double> temperature, Powers& out) {
  const ContactTable& table = network.contacts().table();
  const PairForces& pairs = network.pair_forces();
  for (std::size_t k = 0; k < table.size(); ++k) {
    out.elastic += pairs.elastic[k];
    out.dissipated += pairs.dissipated[k];
  }
  const auto held = network.held();
  if (std::all_of(held.begin(), held.end(), [](std::int32_t wall) { return wall < 0; })) return;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const std::size_t i = at(table.i[k]), j = at(table.j[k]);
    if ((held[i] >= 0) == (held[j] >= 0)) continue;
    const double flow = table.conductivity[k] * table.flow[k] * (temperature[i] - temperature[j]);
    out.heat_lost += held[j] >= 0 ? flow : -flow;
  }
}

void add_walls(const MovingNetwork& network, std::span<const Vec3> velocity,
               std::span<const double> temperature, Powers& out) {
  const Model& model = network.model();
  const Particles& particles = network.particles();
  const ContactLaw& law = model.wall;
  const auto held = network.held();
  for (const auto& contact : network.walls()) {
    const std::size_t i = at(contact.particle);
    const Vec3 normal = outward(contact.wall);
    const Vec3 wall{0, 0, contact.wall == upper ? network.upper_wall_velocity() : 0.0};
    const Vec3 relative = wall - velocity[i];
    const double parting = dot(relative, normal);
    const double push = wall_push(model, particles, contact, temperature[i]);
    const double damped = damped_push(
        push, damping_of(law, push, contact.strain, particles.radius[i], particles.mass[i]), parting);
    out.elastic -= push * parting;
    out.dissipated += (push - damped) * parting;
    const Vec3 slip = relative - parting * normal;
    out.dissipated += push * dot(friction_direction(law.friction, slip, law.friction_speed), slip);
    // The wall pushes the particle inwards and moves along its own normal: friction does no work on it.
    out.wall -= damped * dot(wall, normal);
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
  add_pairs(network, temperature, out);
  add_walls(network, velocity, temperature, out);
  return out;
}

}  // namespace superstep::dynamics
