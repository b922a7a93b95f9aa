#pragma once
/// The staggered implicit scheme against a plain explicit one over a window of a case.

#include <string>
#include <vector>

#include "bench/host/progress.hpp"
#include "case/press/press.hpp"

namespace superstep {

/// One scheme over the window, from one and the same state.
struct MotionRow {
  std::string scheme, settings, status, reason;
  std::uint64_t steps = 0, rejected = 0;
  std::uint64_t force_evaluations = 0;  ///< of attempts that were accepted
  double cpu = 0;                       ///< s
  // NaN unless the status is ok: a scheme that did not come to the end has no error there.
  double error_position = 0;     ///< rms distance of the particles from the reference at the end [m]
  double error_temperature = 0;  ///< rms [K]
};

struct MotionComparison {
  double begin = 0, end = 0;   ///< s
  double travelled = 0;        ///< rms distance that the particles move in the window [m]
  std::string reference;       ///< how it was computed
  double reference_error = 0;  ///< rms distance between two references, one with twice the step [m]
  std::vector<MotionRow> rows;
};

/// Follows the case up to its `motion_window` with its own settings, then compares schemes from there on:
/// staggered with the case's tolerances and tighter ones, plain at several parts of its stability limit.
/// Throws NumericalError when the window or its reference cannot be computed.
[[nodiscard]] MotionComparison compare_motion_schemes(const Press& one, Progress& progress);

[[nodiscard]] std::string motion_table(const MotionComparison& comparison);
[[nodiscard]] std::string motion_csv(const Press& one, const MotionComparison& comparison);

}  // namespace superstep
