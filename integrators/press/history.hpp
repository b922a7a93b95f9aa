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
  // Since the start [J], by the mean of the powers at both ends of each step.
  double wall_work = 0;         ///< of the upper wall on the particles
  double potential_energy = 0;  ///< of their weight
  double elastic_energy = 0;    ///< that contacts and necks have taken up
  double dissipated = 0;        ///< in damping, friction and drag
  double joule_heat = 0;        ///< of the current in particles that are not held at a temperature
  /// To walls, and to hold particles at the temperature of theirs. Of a thermal integrator, what the
  /// current's heat and the change of the content leave.
  double heat_lost = 0;
  double heat_content = 0;  ///< sum of m C T now [J]
  std::int32_t landed = 0;  ///< 1 = the step ended where something jumped (`control = "steady"`)
};

}  // namespace superstep::dynamics
