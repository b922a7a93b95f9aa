#pragma once
/// Heat through contacts and walls.

#include <span>
#include <vector>

#include "dynamics/forces.hpp"
#include "network/network.hpp"

namespace superstep::dynamics {

/// Which particles take the temperature of a wall: its number, or -1.
using Held = std::span<const std::int32_t>;

/// kappa A_ij/|x_i - x_j| of two particles [W/K].
[[nodiscard]] inline double pair_conductance(const ContactPoint& contact) noexcept {
  return contact.conductivity * contact.area / contact.distance;
}

/// kappa A/distance of a particle and a wall [W/K].
[[nodiscard]] double wall_conductance(const ThermalLaw& law, const Particles& particles,
                                      const WallContact& contact) noexcept;

/// m C of particle i [J/K].
[[nodiscard]] inline double heat_capacity(const ThermalLaw& law, const Particles& particles,
                                          std::size_t i) noexcept {
  return particles.mass[i] * value_of(particles.specific_heat, i, law.specific_heat);
}

/// Temperature rates [K/s]: (sum_j kappa A_ij/|x_i - x_j| (T_j - T_i) + the same to walls + H_i)/(m_i C); 0
/// for held particles. Source: Zohdi (2014), eqs 31-35.
///   joule [n]  H_i [W]
/// Each particle adds its pairs in the order of the table: the same bits for any number of threads.
void heat_rates(const ThermalLaw& law, const Particles& particles, const ContactPoints& contacts,
                std::span<const WallContact> walls, Held held, std::span<const double> joule,
                std::span<const double> temperature, std::span<double> rate);

/// Longest step of an explicit scheme [s] in which no temperature goes beyond those around it: m C over the
/// sum of a particle's conductances, the least of all; infinity where nothing conducts. Forward Euler is
/// stable up to there at least.
///   conductance [n]  scratch
[[nodiscard]] double heat_step_limit(const ThermalLaw& law, const Particles& particles,
                                     const ContactPoints& contacts, std::span<const WallContact> walls,
                                     Held held, std::vector<double>& conductance);

/// The same equations as a frozen network for any integrator: rows are the particles that are not held, in
/// their order; ghosts are the six walls. `Network::node_of_row` and `row_of_node` speak of particles.
[[nodiscard]] Network thermal_network(const ThermalLaw& law, const Particles& particles,
                                      const Placement& placement, Held held, std::span<const double> joule);

}  // namespace superstep::dynamics
