#pragma once
/// Speedups of methods that evaluate the Joule heat at different intervals, put on one footing.

#include "results/results.hpp"

namespace superstep {

/// Substeps of a method with a fixed number of stages; empty when they were not counted.
[[nodiscard]] Number substeps(const BenchRow& row);

/// Speedups of stepping over forward Euler as they would be if both evaluated the heat equally often.
struct LikeForLike {
  Number every_substep;    ///< super-time-stepping, too, at each of its substeps
  Number every_superstep;  ///< forward Euler, too, as often as there are supersteps
};

/// From measured CPU times, counted steps and the measured cost of an evaluation.
///   euler, sts  evaluate it once a step; cpu_joule [s] one evaluation
[[nodiscard]] LikeForLike like_for_like(const BenchRow& euler, const BenchRow& sts, double cpu_joule);

}  // namespace superstep
