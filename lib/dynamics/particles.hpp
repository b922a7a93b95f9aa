#pragma once
/// Particles and what changes about them.

#include <cstdint>
#include <vector>

#include "core/vec3.hpp"

namespace superstep::dynamics {

/// What stays the same about n particles.
struct Particles {
  std::vector<std::int64_t> id;  ///< [n] the user's ids, unique
  std::vector<double> radius;    ///< [n] m, > 0
  std::vector<double> mass;      ///< [n] kg, > 0
  // Of particles that differ in their material; empty = all have what the model says.
  std::vector<std::int32_t> material;         ///< [n] number of its material
  std::vector<double> specific_heat;          ///< [n] J/(kg K), > 0
  std::vector<double> conductivity;           ///< [n] of heat [W/(m K)], >= 0
  std::vector<double> electric_conductivity;  ///< [n] S/m, > 0
  std::vector<double> hardness;               ///< [n] contact stiffness over that of the model, > 0

  [[nodiscard]] std::size_t size() const noexcept { return radius.size(); }
  bool operator==(const Particles&) const = default;
};

/// The number of particle i, or that of the model where all are alike.
[[nodiscard]] inline double value_of(const std::vector<double>& own, std::size_t i, double common) noexcept {
  return own.empty() ? common : own[i];
}

/// A bonded pair i < j and what its bond remembers.
struct Bond {
  std::int32_t i, j;
  double overlap;  ///< largest overlap strain since it formed
  double growth;   ///< u of its neck, 0 to 1
};

/// Everything about n particles that changes with time: with the model it decides all that follows.
struct State {
  double time = 0;                  ///< s
  std::vector<Vec3> position;       ///< [n] m
  std::vector<Vec3> velocity;       ///< [n] m/s
  std::vector<double> temperature;  ///< [n] K
  std::vector<double> electric;     ///< [n] current J [A], or potential [V], as the model has it
  std::vector<Bond> bonds;          ///< sorted by (i, j)

  [[nodiscard]] std::size_t size() const noexcept { return position.size(); }
};

}  // namespace superstep::dynamics
