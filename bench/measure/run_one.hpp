#pragma once
/// One integrator over one scene, from preparation to the end, with its costs.

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/host/progress.hpp"
#include "bench/measure/probe_set.hpp"
#include "bench/measure/run_limits.hpp"
#include "case/scene.hpp"
#include "core/error.hpp"
#include "integrators/integrator.hpp"
#include "integrators/method_spec.hpp"
#include "integrators/spans.hpp"

namespace superstep {

/// Writes what this process has of a scene that is built in layers, at an instant [s], into a folder: frame 0
/// is the beginning, and one follows for each output time. Called by all processes at once; what one of them
/// cannot do all throw, as EverybodysError.
using WriteFrame = std::function<void(const Scene& scene, const std::string& folder, std::size_t frame,
                                      double t, std::span<const double> state)>;

/// A file that one of several processes could not write; all know it and stop.
struct EverybodysError : OutputError {
  using OutputError::OutputError;
};

/// What a run does besides integrating; nothing, when it is being timed.
struct RunRequest {
  bool track_inflow = false;
  std::vector<double> spans = {};           ///< [fields] of the scene; empty: the run finds them
  const ProbeSet* probes = nullptr;         ///< record these at step ends
  const std::atomic<bool>* stop = nullptr;  ///< set from outside: stop at the next step end
  Progress* progress = nullptr;
  RunLimits limits = {};
  /// Called at every output time with its number, the time [s] and the state: of a scene that is built in
  /// layers, of the rows that are here.
  std::function<void(std::size_t output, double t, std::span<const double> state)> observe = {};
  /// Of a scene that is built in layers: where its frames go, empty = nowhere, and who writes them here.
  std::string frames = {};
  WriteFrame write_frame = {};
  bool watches_range = false;  ///< the result says how far values leave theirs
};

struct RunResult {
  Outcome outcome;
  Statistics statistics;
  std::uint64_t sweeps = 0, jacobians = 0;  ///< of the right-hand side, preparation included
  std::uint64_t potential_solves = 0;       ///< steady potentials solved for while integrating
  RhsCounters pilot_work;                   ///< of the run that found the spans
  std::optional<double> settled_at;         ///< s, when the potential stopped being stepped
  std::vector<double> spans;                ///< [fields] that tolerances referred to; empty: nobody asked
  double cpu_pilot = 0;                     ///< s, of the pilot run that found them
  double cpu_prepare = 0, wall_prepare = 0, cpu_stepping = 0, wall_stepping = 0;  ///< s
  std::string choice;    ///< what the method chose by itself and why; may be empty
  double t_reached = 0;  ///< s
  /// [fields] how far values at output times left the range that they can take [K or V]; empty: nobody asked.
  std::vector<double> overshoot;
  ProbeHistory history;  ///< begins with the initial state; empty unless probes were asked for
  bool threw = false;    ///< the outcome is an exception's
  int processes = 1;     ///< that took part; their CPU times are added up, and the longest wall time counts
  /// Of several processes: exact (the result is that of one) or gathered (one did it for all); else empty.
  std::string distributed;
  std::uint64_t reductions = 0;                     ///< sums and maxima over all processes
  std::uint64_t halo_messages = 0, halo_bytes = 0;  ///< of all processes together
  double peak_memory_mb = 0;                        ///< of all processes together; 0 = one took part
  double imbalance = 1;                             ///< most entries that a process has over their mean
};

/// The method's own bound of its error over the span; nothing where it has none.
[[nodiscard]] inline std::optional<double> error_bound_of(const RunResult& run) {
  return run.statistics.error_bound > 0 ? std::optional(run.statistics.error_bound) : std::nullopt;
}
/// The part of it that is rounding.
[[nodiscard]] inline std::optional<double> rounding_bound_of(const RunResult& run) {
  return error_bound_of(run) ? std::optional(run.statistics.rounding_bound) : std::nullopt;
}

/// Builds the method anew and runs it. What the method cannot do or fails to do is an outcome. Stepping
/// begins with `start`: estimates of the spectrum and the first step size are part of it.
[[nodiscard]] RunResult run_one(const Scene& scene, const MethodSpec& spec, const RunRequest& wanted);

/// What a scene says about any run over it: output times, ranges of values, settling. Spans are not among it.
[[nodiscard]] Plan scene_plan(const Scene& scene);

/// Spans of the scene's fields, by a pilot run where declared values do not say them.
[[nodiscard]] Spans scene_spans(const Scene& scene, const std::atomic<bool>* stop = nullptr);

/// The scene's description of a field of the right-hand side, by name.
[[nodiscard]] const FieldScene& scene_field(const Scene& scene, const std::string& name);

}  // namespace superstep
