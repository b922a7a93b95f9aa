#pragma once
/// What a run of moving particles reports after every step.

#include <cstdint>
#include <string>
#include <vector>

namespace superstep::dynamics {

/// One accepted step; the first row is the initial state.
struct HistoryRow {
  double time = 0;             ///< s
  std::int32_t phase = 0;      ///< number of the phase that the step belongs to
  double volume_fraction = 0;  ///< of particles below the lowest position of the upper wall
  double mean_temperature = 0, max_temperature = 0;  ///< K
  double wall_force = 0;                             ///< normal force on the upper wall [N]
  double kinetic_energy = 0;                         ///< J
  std::int64_t bonds = 0, contacts = 0;
  double step = 0;              ///< size of the step [s]
  std::int64_t iterations = 0;  ///< fixed-point iterations of the step
  std::int64_t rejections = 0;  ///< restarts of the step
  std::int32_t landed = 0;      ///< 1 = the step ended where something jumped (`control = "steady"`)
};

}  // namespace superstep::dynamics
