#pragma once
/// Round numbers along an axis.

#include <vector>

namespace superstep {

struct AxisRange {
  double low = 0, high = 1;
};

/// [low, high], widened about its middle where it is no wider than the roundings of its ends: what moves by
/// roundings alone is constant, and there is no room for marks. Ends beyond 1e300 are cut.
[[nodiscard]] AxisRange room_for_marks(double low, double high) noexcept;

/// 1, 2 or 5 times the power of ten that cuts `span` > 0 into about five.
[[nodiscard]] double round_step(double span) noexcept;

/// Multiples of `step` in [low, high], give or take a rounding; ascending. Takes (high - low)/step steps,
/// whatever the sizes of the ends.
[[nodiscard]] std::vector<double> round_marks(double low, double high, double step);

}  // namespace superstep
