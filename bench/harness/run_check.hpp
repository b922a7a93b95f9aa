#pragma once
/// `run --verify`: the same run again, ten times tighter and by a method of another family.

#include <atomic>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/host/progress.hpp"
#include "bench/measure/run_one.hpp"
#include "results/results.hpp"

namespace superstep {

struct RunCheck {
  std::string spec;  ///< of the other method
  Outcome outcome;
  std::vector<double> distance, spans;  ///< [fields] rms, worst over the output times [K or V]; spans
  std::vector<std::optional<double>> delivered;  ///< [fields] over the tolerance; empty where there is none
  double cpu_seconds = 0;
};

/// Integrates once more and compares.
///   states  [output times] of the run that is checked
[[nodiscard]] RunCheck check_run(const Scene& scene, const MethodSpec& spec, const RunResult& run,
                                 std::span<const std::vector<double>> states, const std::atomic<bool>& stop,
                                 Progress& progress, const RunLimits& limits = {});

/// What the distance makes of a run that ended well: ok, or inaccurate.
[[nodiscard]] Outcome judge_check(const Scene& scene, const RunCheck& check);

void add_check(const RunCheck& check, RunRecord& record);

}  // namespace superstep
