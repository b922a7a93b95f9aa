#pragma once
/// The performance gate: is this build as good as the recorded one?

#include <functional>
#include <string>
#include <vector>

#include "reports/gate/results_file.hpp"
#include "reports/gate/timing_rule.hpp"

namespace superstep {

/// What is tolerated. A method with fixed steps does exactly the same work on every machine; one that
/// controls its steps decides by comparing numbers whose last digits differ between instruction sets.
struct GateLimits {
  double adaptive_counters = 0.02;  ///< more work of an adaptive method, relative
  double adaptive_counts = 2;       ///< and so many more are never worth a word
  double errors = 0.05;             ///< larger error, relative, beyond the reference's own error bar
  double balance = 1e-6;            ///< heat balance [-] that is never worth a word
  double overshoot = 1e-6;          ///< of the span; a range left by less is never worth a word
  double instructions = 0.005;      ///< more instructions, relative
  double memory = 0.10;             ///< larger resident set, relative
  double memory_mb = 8;             ///< and what runs of other methods and libraries leave behind, 1e6 bytes
  TimingLimits timing = timing_limits;  ///< what times must be like to be judged, and what is slower
  double unsure = 1.10;  ///< clearly not slower: the interval lies below this, its estimate below `slower`
};

enum class GateVerdict { passed, better, not_judged, inconclusive, regressed };

/// One thing that was looked at.
struct GateFinding {
  std::string case_name, spec, what;
  std::string before, now;
  GateVerdict verdict = GateVerdict::passed;
};

struct GateReport {
  GateVerdict verdict = GateVerdict::passed;  ///< passed, inconclusive or regressed
  std::string results, baseline;              ///< files
  std::vector<GateFinding> findings;          ///< all that did not simply pass
  std::size_t passed = 0;                     ///< how many did
  std::vector<std::string> notes;
};

/// Judges `now` against `baseline`: statuses, counters, errors and overshoot; memory where both come from the
/// same build flags and number of threads and processes, and CPU times where also from the same kind of
/// processor. First each set of timings is compared with itself. What was not measured cannot be told, and is
/// no regression.
///   is_adaptive  of an integrator's name
[[nodiscard]] GateReport judge(const ResultsFile& now, const ResultsFile& baseline,
                               const std::function<bool(const std::string&)>& is_adaptive,
                               const GateLimits& limits = {});

[[nodiscard]] const char* verdict_name(GateVerdict verdict) noexcept;
[[nodiscard]] std::string gate_markdown(const GateReport& report);
[[nodiscard]] std::string gate_json(const GateReport& report);

}  // namespace superstep
