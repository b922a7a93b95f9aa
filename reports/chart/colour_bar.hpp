#pragma once
/// The scale of colours beside pictures of particles.

#include <limits>
#include <string>

namespace superstep {

/// From the smallest to the largest of some values.
struct ValueRange {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void include(double value) noexcept {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  /// Place of a value in the range, 0 .. 1; 0 where all values are the same.
  [[nodiscard]] double fraction(double value) const noexcept {
    return high > low ? (value - low) / (high - low) : 0;
  }
};

/// An SVG of the colours of a range with the name of the field.
[[nodiscard]] std::string colour_bar(const std::string& field, const std::string& unit,
                                     const ValueRange& range);

/// "t = 25 ms": a time [s] in the unit that reads best.
[[nodiscard]] std::string time_text(double t);

}  // namespace superstep
