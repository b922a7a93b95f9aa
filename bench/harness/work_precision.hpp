#pragma once
/// The work-precision sweep: every method of the registry over a ladder of tolerances or steps.

#include <atomic>
#include <string>
#include <vector>

#include "bench/harness/harness.hpp"
#include "bench/host/progress.hpp"
#include "case/scene.hpp"
#include "results/study/work_precision.hpp"

namespace superstep {

struct WorkPrecisionOptions {
  std::vector<std::string> integrators;  ///< SPECs; empty = the ladders of the registry
  std::string reference;                 ///< SPEC; empty = the exponential for linear scenes, else CVODE
  bool use_cache = true;
  int repetitions = 1;
  int threads = 1;
  RunLimits limits{.seconds = usual_time_limit};  ///< of each point in each repetition
  const std::atomic<bool>* stop = nullptr;
};

/// SPECs of the sweep: the ladder of every method in the registry.
[[nodiscard]] std::vector<std::string> work_precision_specs();

/// Runs the sweep, repetitions interleaved. Throws NumericalError when the reference fails.
[[nodiscard]] WorkPrecision work_precision(const Scene& scene, const WorkPrecisionOptions& options,
                                           Progress& progress);

}  // namespace superstep
