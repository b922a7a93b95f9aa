#pragma once
/// results.json of `superstep bench`, read back.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/gate/bootstrap.hpp"
#include "results/results.hpp"

namespace superstep {

/// Counters that cost time; fewer is better.
inline constexpr const char* counter_columns[] = {"steps",     "rejected",       "rhs",
                                                  "jacobians", "factorizations", "solves"};
/// Distances to the reference, each in one column a field.
inline constexpr const char* error_columns[] = {"error_probe_mean", "error_rms", "error_max"};

/// One method on one case.
struct MeasuredRow {
  std::string integrator, spec, status;
  std::map<std::string, double> numbers;  ///< the columns of results.csv that hold a number
  std::vector<double> cpu_stepping;       ///< s, one per round
  std::vector<double> yardstick;          ///< s, one per round: see bench/host/yardstick.hpp

  /// A column's number; empty when it was not measured.
  [[nodiscard]] std::optional<double> number(const std::string& column) const;
};

struct MeasuredCase {
  std::string name, baseline;  ///< baseline: SPEC of the method that the others are compared with
  std::vector<MeasuredRow> rows;
  BenchCase head = {};  ///< the case without its rows

  [[nodiscard]] const MeasuredRow* find(const std::string& spec) const;
};

struct ResultsFile {
  std::string path, revision, processor, flags;
  std::string counted_by;  ///< all that a count of instructions depends on; empty = none were counted
  int threads = 1;
  bool interrupted = false;  ///< methods that had not been reached by then are left out
  std::vector<MeasuredCase> cases;

  [[nodiscard]] const MeasuredCase* find(const std::string& name) const;
  /// The case of another file; null where it is not here. Throws InputError where another one has its name:
  /// of another size or unit, or with other times.
  [[nodiscard]] const MeasuredCase* find_same(const MeasuredCase& one, const std::string& other_path) const;
  /// True when some method was timed.
  [[nodiscard]] bool has_samples() const;
};

/// Reads a file, or results.json in a folder. Throws InputError, also for a method that is "ok" and has none
/// of the numbers that it is judged by.
[[nodiscard]] ResultsFile read_results(const std::string& path);

/// The method's CPU time of stepping in units of the case's baseline method, round by round; the baseline
/// method itself in units of the yardstick. Of the rounds that both have: an interrupt comes between two
/// methods. Empty when it was not timed.
[[nodiscard]] PairedTimings relative_timings(const MeasuredCase& one, const MeasuredRow& row);

}  // namespace superstep
