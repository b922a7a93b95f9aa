#pragma once
/// The benchmark of one case: verify every method against the reference, warm up, then time in interleaved
/// rounds.

#include <atomic>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/harness/reference.hpp"
#include "bench/host/progress.hpp"
#include "bench/measure/run_limits.hpp"
#include "case/scene.hpp"
#include "results/results.hpp"

namespace superstep {

/// Wall time after which a benchmark goes on without a method [s].
inline constexpr double usual_time_limit = 600;

struct HarnessOptions {
  std::vector<std::string> integrators;  ///< SPECs; empty = those of the case
  std::string reference;  ///< SPEC; empty = as the scene needs; "none" = errors are not measured
  bool use_cache = true;
  int repetitions = 3;                            ///< timed runs of each method, >= 1
  bool count_instructions = false;                ///< under callgrind, in processes of their own
  int threads = 1;                                ///< recorded beside the timings
  std::optional<SampledMeasure> sampled;          ///< rule of a published table; empty = nothing is published
  RunLimits limits{.seconds = usual_time_limit};  ///< of each method in each repetition
  const std::atomic<bool>* stop = nullptr;        ///< Ctrl-C: what has been verified by then is reported
};

/// SPECs that a case is benchmarked with: those asked for, else those of the case, else all families; the
/// baseline is appended when it is not among them.
[[nodiscard]] std::vector<std::string> contenders(const BenchSettings& bench,
                                                  const std::vector<std::string>& asked);

/// A result that holds what the head of a case says, and nothing measured yet.
[[nodiscard]] BenchCase begin_case(const CaseHead& head);
/// A row of that case that nothing was measured for yet.
[[nodiscard]] BenchRow begin_row(const BenchCase& one, const std::string& spec, int threads);
/// Speedups of all timed rows over the baseline, when that was timed.
void compare_with_baseline(BenchCase& one);
/// Names the methods of which the reference can not tell whether they keep their tolerance.
void warn_of_untold_tolerances(BenchCase& one);
/// `numerator / denominator`; empty unless both are > 0.
[[nodiscard]] Number quotient(double numerator, double denominator);

/// What the reference may cost where a method may cost that: it is nobody's choice, so only time counts.
[[nodiscard]] RunLimits limits_of_reference(const RunLimits& limits);

/// Order of n contenders in a round: rotated by one from round to round, so that none always follows the same
/// one.
[[nodiscard]] std::vector<std::size_t> round_order(std::size_t n, std::size_t round);

/// Median, smallest and largest; the median of an even number is the mean of the middle two. Not empty.
[[nodiscard]] Timing summarize(const std::vector<double>& seconds);

/// Measures one case. Numerical failures are rows, not exceptions.
///   cpu_setup [s]  CPU time that reading and building the scene took
[[nodiscard]] BenchCase bench_case(const Scene& scene, double cpu_setup, const HarnessOptions& options,
                                   Progress& progress);

}  // namespace superstep
