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

  [[nodiscard]] std::size_t size() const noexcept { return radius.size(); }
};

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
