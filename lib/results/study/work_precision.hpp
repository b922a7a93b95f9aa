#pragma once
/// Work against error: the points of a sweep over tolerances and steps, and who wins at which error.

#include <string>
#include <vector>

#include "core/text/options.hpp"
#include "results/results.hpp"

namespace superstep {

/// One SPEC of the sweep.
struct WorkPrecisionPoint {
  std::string family;  ///< the method with everything but the swept key, e.g. "cvode linsol=pcg"
  std::string spec, integrator, params, status, reason;
  std::uint64_t sweeps = 0, steps = 0;
  std::optional<Timing> cpu{};  ///< s, preparation and stepping
  std::vector<double>
      error_rms{};  ///< at each output time, in the field's unit; empty unless it came to its end
  double worst = 0, worst_relative = 0;  ///< largest of error_rms, and over the field's span
  [[nodiscard]] bool ok() const noexcept { return status == "ok"; }
};

/// The sweep of one case.
struct WorkPrecision {
  std::string case_name, title, unit, reference;
  Number reference_error;  ///< error bar of the reference, rms in the field's unit
  double span = 0;         ///< of the field
  std::size_t unknowns = 0;
  int repetitions = 0, threads = 1;
  std::vector<double> output_times;  ///< s
  std::vector<WorkPrecisionPoint> points;
};

/// What a SPEC has in common with its neighbours on a ladder: name and settings without the ones that ladders
/// step through.
[[nodiscard]] std::string family_of(const Spec& spec);

/// The fastest method that reaches an error level.
struct LevelWinner {
  double level = 0;                               ///< worst error over the span
  const WorkPrecisionPoint* winner = nullptr;     ///< null when nobody reaches it
  const WorkPrecisionPoint* runner_up = nullptr;  ///< fastest of another family; may be null
  Number lead;                                    ///< CPU of the runner-up over that of the winner
  /// CPU of the cheapest forward Euler run that reaches the level, over the winner's; empty where none does.
  Number over_euler;
  const char* without_euler = "";  ///< in words, where it is empty: none reaches the level, or none was run
};

/// Winners at 1e-1, 1e-2, ..., 1e-10 of the span; levels below the reference's error bar are left out.
[[nodiscard]] std::vector<LevelWinner> winners(const WorkPrecision& study);

/// work_precision.csv: one row per point, failed and unstable ones too.
[[nodiscard]] std::string work_precision_csv(const WorkPrecision& study);
/// Points and winners as aligned tables.
[[nodiscard]] std::string work_precision_table(const WorkPrecision& study, bool color);

}  // namespace superstep
