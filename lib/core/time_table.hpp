#pragma once
/// A quantity given at instants, linear between them: fixed values, sources and ambients that change in time.

#include <utility>
#include <vector>

namespace superstep {

/// Two equal neighbouring instants are a step: the first value holds before it, the second from it on.
struct TimeTable {
  std::vector<double> time;   ///< s, ascending, not empty; at most two equal neighbours
  std::vector<double> value;  ///< same length

  /// Value at t, at a step the one after it; before the first and after the last instant the end values hold.
  [[nodiscard]] double at(double t) const noexcept;
  /// The line that the table is between `begin` and `end`, two instants with no knot between them: its value
  /// at `begin` as seen from there on, and its slope.
  struct Line {
    double value = 0, slope = 0;
  };
  [[nodiscard]] Line line(double begin, double end) const noexcept;
  /// Limit from the left: as `at`, but at a step the value before it.
  [[nodiscard]] double before(double t) const noexcept;
  /// Integral from t0 to t1 [s times the unit of the values], exact up to rounding; negative where t1 < t0.
  [[nodiscard]] double integral(double t0, double t1) const noexcept;
  /// Smallest and largest value for t0 <= t <= t1, with both values of a step inside or at t1.
  [[nodiscard]] std::pair<double, double> range(double t0, double t1) const noexcept;
  [[nodiscard]] double lowest() const noexcept;
  [[nodiscard]] double highest() const noexcept;
};

}  // namespace superstep
