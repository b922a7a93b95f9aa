#pragma once
/// What a run of moving particles left in its folder, read for a report.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace superstep {

/// A quantity of history.csv, one value per instant that was kept.
struct MotionHistory {
  std::vector<double> time;                               ///< s, ascending
  std::vector<double> volume_fraction;                    ///< below the lowest position of the upper wall
  std::vector<double> mean_temperature, max_temperature;  ///< K
  std::vector<double> wall_force;                         ///< on the upper wall [N]
  std::vector<double> bonds, contacts;
  /// Since the start [J]; empty in folders of programs that did not keep account.
  std::vector<double> wall_work, kinetic, potential, elastic, dissipated;
  std::vector<double> joule_heat, heat_lost, heat_gained;
};

/// One phase of the press as far as the run came.
struct MotionPhase {
  std::string name;
  double begin = 0, end = 0;                         ///< s
  std::size_t steps = 0;                             ///< accepted
  double volume_fraction = 0;                        ///< at the end, like the following ones
  double mean_temperature = 0, max_temperature = 0;  ///< K
  double wall_force = 0;                             ///< N
  double largest_wall_force = 0;                     ///< during the phase [N]
  std::uint64_t bonds = 0, contacts = 0;
};

/// The rear half of the particles at one instant, seen from the front (from -y).
struct MotionFrame {
  struct Sphere {
    std::int64_t id = 0;
    double across = 0, height = 0;  ///< x and z of the centre [m]
    double depth = 0;               ///< y of the centre minus y of the plane that halves the box, >= 0 [m]
    double radius = 0;              ///< m
    double temperature = 0;         ///< K
    double electric = 0;            ///< current [A] or potential [V], as the case has it
  };
  double time = 0;              ///< s
  double upper_wall = 0;        ///< its height [m]
  std::size_t behind = 0;       ///< particles of the rear half; more than `spheres` when some were left out
  std::vector<Sphere> spheres;  ///< from the rear to the front
};

struct MotionInput {
  MotionHistory history;
  std::vector<MotionPhase> phases;             ///< in their order
  double largest_fraction = 0;                 ///< of the volume
  double largest_fraction_at = 0;              ///< s
  std::array<double, 3> box_min{}, box_max{};  ///< m; all 0 when unknown
  std::vector<MotionFrame> frames;             ///< ascending in time; none without a known box
  std::string electric;                        ///< "current" or "potential"; empty = neither
};

}  // namespace superstep
