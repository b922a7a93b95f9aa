#pragma once
/// Plain results of a benchmark, as the harness fills them and the renderers show them.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "results/observations.hpp"

namespace superstep {

/// A measured number; empty = not measured or not applicable.
using Number = std::optional<double>;

/// Error measures of one field of one run (Rojek & Nisar 2026, eqs 42-47), in the field's unit unless stated.
struct FieldErrors {
  Number probe_mean;       ///< mean |difference| at the probe over the step ends of the transient
  Number rms, max;         ///< over free nodes, worst over the output times
  Number relative_rms;     ///< rms over the field's span [-]
  Number overshoot;        ///< how far a value leaves the range that the maximum principle allows
  Number balance;          ///< (entered - stored) / entered [-]
  Number decay_rate;       ///< k of |difference| = Z exp(-k t) at the probe [1/s]
  Number decay_r2;         ///< of that fit [-]
  Number reference_error;  ///< error bar of the reference, rms
  /// Mean, k [1/s] and R2 at the probe by the rule of a published table: see SampledMeasure.
  Number published_mean, published_rate, published_r2;
  Number span;  ///< largest minus smallest value over all nodes and the whole run: what tolerances refer to
  /// rms over what was asked for, rtol times the span [-]; empty where nothing was, or the reference cannot
  /// tell.
  Number delivered;
  Number distance_to_cvode;  ///< rms over the span, worst over the output times [-]
};

/// How a published table took its errors at the probe: at the instants from, from + every, ..., to.
struct SampledMeasure {
  std::string field;                   ///< "temperature" or "potential"
  double every = 0, from = 0, to = 0;  ///< s
  /// true: both codes write the state of their first step end at or after each instant, and the baseline's is
  /// subtracted as if both were of one moment; false: the error against the reference at the instant itself.
  bool as_written = false;
};

/// Median and extremes of repeated timings [s].
struct Timing {
  double median = 0, min = 0, max = 0;
};

/// One integrator on one case: a line of results.csv.
struct BenchRow {
  std::string case_name, integrator, params, status, reason;
  std::string spec;    ///< integrator and params as the user wrote them
  std::string choice;  ///< what the method chose by itself and why; may be empty
  std::size_t nodes = 0, contacts = 0;
  double t_end = 0;  ///< s
  int repetitions = 0, threads = 1;
  std::optional<Timing> cpu_total, cpu_stepping, wall_stepping;
  std::vector<double> cpu_stepping_samples;  ///< [repetitions] s, in the order of the rounds
  std::vector<double> yardstick_samples;     ///< [repetitions] s, a fixed piece of work around each
  Number speedup_total, speedup_stepping, speedup_theory;  ///< against the baseline of the case
  Number cpu_prepare;       ///< s, before the first step: spectrum, factorization, choice; median
  Number speedup_prepared;  ///< preparation and stepping together, against the baseline
  Number cpu_pilot;       ///< s, of the run that found the spans for all methods; empty where none was needed
  Number error_bound;     ///< over the span [-], proven but for roundings; empty = the method has none
  Number rounding_bound;  ///< the part of it that is rounding
  Number cpu_verify;      ///< s, of runs by which a method checked itself; empty = it did not
  int processes = 1;      ///< that took part
  std::optional<std::uint64_t> steps, rejected, rhs, jacobians, factorizations, solves, max_stages;
  /// Executed between start and end of the integration, as callgrind counts them; empty = nobody asked.
  std::optional<std::uint64_t> instructions;
  Number peak_memory_mb;                 ///< 1e6 bytes, of the process during the method's warm-up run
  FieldErrors errors;                    ///< of the temperature, or of the only field
  std::optional<FieldErrors> potential;  ///< only when there are two fields
  std::string reference;                 ///< SPEC of the reference; empty = none

  [[nodiscard]] bool ok() const noexcept { return status == "ok"; }
};

/// How the reference of a case came about.
struct ReferenceFacts {
  std::string spec;
  bool from_cache = false;
  double cpu_seconds = 0;  ///< of its integration; 0 when it came from the cache
};

/// Something that a scene does not need and that was not done.
struct SkippedWork {
  std::string what, because;
};

/// One case with all its rows.
struct BenchCase {
  std::string name, title, source, baseline;
  std::size_t nodes = 0, contacts = 0, unknowns = 0;
  double t_end = 0, cpu_setup = 0;   ///< s
  std::vector<double> output_times;  ///< s
  std::string unit;                  ///< of the errors: "K" or "V"
  std::optional<ReferenceFacts> reference;
  std::optional<SampledMeasure>
      sampled;       ///< rule of the `published_` errors; empty where nothing is published
  Number cpu_joule;  ///< s, what a substep costs more when it evaluates the Joule heat
  std::vector<BenchRow> rows;
  std::vector<std::string> warnings;
  std::vector<SkippedWork> skips;
  CaseObservations observations;  ///< for charts; not part of results.json
};

/// A named fact about the machine or the build, in the order in which it is shown.
struct Fact {
  std::string name, value;
};

/// Everything that one `superstep bench` measured.
struct BenchReport {
  std::string version, revision;
  std::vector<Fact> machine, libraries;
  int repetitions = 0, threads = 1;
  bool interrupted = false;
  std::vector<BenchCase> cases;
};

/// What a steady current between two electrodes does at the end of a run.
struct SteadyCurrent {
  double voltage = 0;                      ///< V
  double current_in = 0, current_out = 0;  ///< A
  double resistance = 0;                   ///< Ohm; infinite when there is none
  double joule_heat = 0;                   ///< W
};

/// What a run of moving particles has besides.
struct MotionRecord {
  struct Snapshot {
    std::string file;                 ///< in the folder of the run
    double time = 0, upper_wall = 0;  ///< s; height of the wall [m]
  };
  /// The last step of a phase, see history.csv.
  struct PhaseEnd {
    std::string phase;
    double time = 0;                                   ///< s
    double volume_fraction = 0;                        ///< -
    double mean_temperature = 0, max_temperature = 0;  ///< K
    double wall_force = 0;                             ///< N
    std::size_t bonds = 0, contacts = 0;
  };
  /// CPU time [s].
  struct Parts {
    double contacts = 0, forces = 0, heat = 0, current = 0, rest = 0;
  };
  std::vector<double> box_min, box_max;  ///< [3] m, corners at the start
  std::vector<Snapshot> snapshots;
  std::vector<PhaseEnd> phase_ends;
  std::uint64_t iterations = 0, neighbour_lists = 0;
  Parts cpu_parts;
};

/// Everything about one run of `superstep run` that its CSV files do not hold.
struct RunRecord {
  std::string version, revision;
  std::string case_name, title, source;
  std::string integrator, params, choice, status, reason;
  double t_end = 0, t_reached = 0;  ///< s
  std::size_t nodes = 0, contacts = 0, unknowns = 0;
  std::uint64_t steps = 0, rejected = 0, rhs = 0, jacobians = 0, factorizations = 0, solves = 0;
  std::uint64_t potential_solves = 0;    ///< steady potentials solved for while integrating
  std::string verified_by;               ///< SPEC that `--verify` ran as well; empty = it did not
  std::optional<double> delivered;       ///< error over the tolerance asked for, as far as verified [-]
  Number error_bound;                    ///< the method's own, over the span [-]; empty = it has none
  Number rounding_bound;                 ///< the part of it that is rounding
  std::vector<double> spans;             ///< [fields] K or V; empty = no tolerance asked for them
  double cpu_pilot = 0, cpu_verify = 0;  ///< s
  std::optional<double> settled_at;      ///< s, when the potential became steady and was no longer stepped
  std::optional<SteadyCurrent> electrodes;
  int max_stages = 0, threads = 1;
  double cpu_setup = 0, cpu_prepare = 0, cpu_stepping = 0, wall_stepping = 0;  ///< s
  double peak_memory_mb = 0;                                                   ///< 1e6 bytes
  int processes = 1;        ///< that took part; CPU times are their sums
  std::string distributed;  ///< how several of them did it: exact | gathered; empty = there was one
  std::uint64_t reductions = 0, halo_messages = 0, halo_bytes = 0;
  double imbalance = 1;  ///< most entries of the network that a process has, over their mean
  std::vector<std::string> files, warnings;
  std::vector<SkippedWork> skips;
  std::vector<Fact> machine, libraries;
  std::optional<MotionRecord> motion;  ///< of moving particles
};

}  // namespace superstep
