#pragma once
/// A quantity given at instants, linear between them: fixed values, sources and ambients that change in time.

#include <vector>

namespace superstep {

struct TimeTable {
  std::vector<double> time;   ///< s, ascending, not empty
  std::vector<double> value;  ///< same length

  /// Value at t; before the first and after the last instant the end values hold.
  [[nodiscard]] double at(double t) const noexcept;
  [[nodiscard]] double lowest() const noexcept;
  [[nodiscard]] double highest() const noexcept;
};

}  // namespace superstep
