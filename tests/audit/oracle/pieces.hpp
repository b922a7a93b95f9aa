#pragma once
/// The run cut into pieces on which every table of time is a straight line.

#include <vector>

#include "audit/scenes/random_scene.hpp"
#include "core/time_table.hpp"

namespace superstep::audit {

/// A table on one piece: value at its beginning and change per second. One-sided where the table steps.
struct Line {
  double value = 0, slope = 0;
  [[nodiscard]] double at(double since) const noexcept { return value + slope * since; }
};

/// The table from t0 to t1, between which it has no knot.
[[nodiscard]] Line line_of(const TimeTable& table, double t0, double t1);

/// 0, every knot of every table inside the run, `further` times, t_end: ascending, each once.
[[nodiscard]] std::vector<double> knots(const StatedScene& scene, const std::vector<double>& further = {});

/// Times at which a fixed temperature passes a corner of a table of conductivity: a kink for its neighbours.
[[nodiscard]] std::vector<double> corner_times(const StatedScene& scene);

}  // namespace superstep::audit
