#pragma once
/// Tables of the source paper, embedded at build time.

#include <optional>
#include <string>
#include <vector>

#include "results/results.hpp"

namespace superstep {

/// Published results of one parameter set of super-time-stepping; nu = 0 is forward Euler.
struct PublishedRun {
  double nu = 0, n = 1;
  Number error_mean, decay_rate, r2;  ///< in the field's unit, 1/s, -
  Number substeps, cpu_total, cpu_stepping, speedup_total, speedup_stepping;
};

/// Published results of one case.
struct PublishedCase {
  std::string source;                          ///< as the case file states it
  std::string error_table, performance_table;  ///< "table 1", "table 2"
  std::string field;                           ///< that the errors are of
  SampledMeasure measure;                      ///< how the errors were taken, as far as it can be told
  bool rate_times_ln10 = false;                ///< printed decay rates are too large by ln 10
  std::vector<PublishedRun> runs;
};

/// What is published about a case, by the `source` of its case file; empty for other sources.
[[nodiscard]] std::optional<PublishedCase> published_case(const std::string& source);

/// How the errors of that case were taken; empty for other sources.
[[nodiscard]] std::optional<SampledMeasure> published_measure(const std::string& source);

}  // namespace superstep
