#pragma once
/// Where energy comes from and where it goes at one instant.

#include <span>

#include "dynamics/moving_network.hpp"

namespace superstep::dynamics {

/// Everything in watts.
struct Powers {
  double wall = 0;        ///< work that the upper wall does on the particles
  double elastic = 0;     ///< that contacts and necks take up: repulsion that is left, and pull
  double dissipated = 0;  ///< in damping, friction and drag
  double weight = 0;      ///< work of gravity
  double joule = 0;       ///< heat of the current in particles that are not held
  double heat_lost = 0;   ///< from those into walls and into particles that walls hold at their temperature
};

/// Powers of the forces and fluxes at the instant for which the network last took its forces whole.
[[nodiscard]] Powers powers_of(const MovingNetwork& network, std::span<const Vec3> velocity,
                               std::span<const double> temperature);

}  // namespace superstep::dynamics
