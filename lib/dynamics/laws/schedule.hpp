#pragma once
/// What the press does when.

#include <optional>
#include <string>
#include <vector>

namespace superstep::dynamics {

/// One phase, from the end of the one before (or the start of the run) to `end`.
struct Phase {
  std::string name;
  double begin = 0, end = 0;                    ///< s
  double upper_wall_begin = 0, upper_wall = 0;  ///< height of the upper wall at begin and end [m]
  std::optional<double> lower, upper;           ///< current [A] or potential [V] of the electrified walls

  /// Speed of the upper wall along z [m/s].
  [[nodiscard]] double wall_velocity() const noexcept {
    return (upper_wall - upper_wall_begin) / (end - begin);
  }
  /// Height of the upper wall [m]; begin <= t <= end. Exact at both ends.
  [[nodiscard]] double wall_height(double t) const noexcept {
    const double done = (t - begin) / (end - begin);
    return (1 - done) * upper_wall_begin + done * upper_wall;
  }
};

/// Phases one after the other; at least one.
class Schedule {
 public:
  Schedule() = default;
  explicit Schedule(std::vector<Phase> phases) : phases_(std::move(phases)) {}

  [[nodiscard]] const std::vector<Phase>& phases() const noexcept { return phases_; }
  /// The phase that a step from t on belongs to; the last one at and after the end.
  [[nodiscard]] const Phase& at(double t) const noexcept {
    for (const auto& phase : phases_)
      if (t < phase.end) return phase;
    return phases_.back();
  }
  /// z*: the lowest height that the upper wall is scheduled to reach [m].
  [[nodiscard]] double lowest_wall() const noexcept {
    double lowest = phases_.front().upper_wall_begin;
    for (const auto& phase : phases_)
      if (phase.upper_wall < lowest) lowest = phase.upper_wall;
    return lowest;
  }

 private:
  std::vector<Phase> phases_;
};

}  // namespace superstep::dynamics
