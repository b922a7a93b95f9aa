#pragma once
/// Which curves share a chart.

#include <functional>
#include <string>
#include <vector>

#include "reports/chart/palette.hpp"
#include "results/observations.hpp"

namespace superstep {

/// A curve with its look, which is the same in every chart.
struct LookedCurve {
  const ProbeCurve* curve = nullptr;
  Look look;
};

/// Curves of one chart: one field at one probe.
struct CurvePanel {
  std::string title;
  std::vector<LookedCurve> curves;
};

/// Panels in order of appearance. Super-time-stepping has one for each value of `sts_key` ("nu" or "n");
/// every other method has one of its own; few curves share a single one.
[[nodiscard]] std::vector<CurvePanel> curve_panels(const std::vector<ProbeCurve>& curves,
                                                   const std::string& sts_key);

}  // namespace superstep
