#pragma once
/// From values to pixels, and where the ticks go.

#include <string>
#include <vector>

#include "reports/chart/chart.hpp"

namespace superstep {

struct Tick {
  double value = 0;
  std::string label;  ///< empty = a small tick
};

class ChartScale {
 public:
  /// Covers [low, high] of the data, widened to round numbers, on pixels [first, last].
  ChartScale(const ChartAxis& axis, double low, double high, double first, double last);

  [[nodiscard]] bool shows(double value) const noexcept;
  [[nodiscard]] double pixel(double value) const noexcept;
  [[nodiscard]] const std::vector<Tick>& ticks() const noexcept { return ticks_; }

 private:
  void make_linear(const ChartAxis& axis);
  void make_logarithmic(const ChartAxis& axis);
  [[nodiscard]] double position(double value) const noexcept;

  bool logarithmic_;
  double low_, high_, first_, last_;
  std::vector<Tick> ticks_;
};

}  // namespace superstep
