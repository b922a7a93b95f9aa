#pragma once
/// Verification of one integrator against the reference, before anything is timed.

#include <atomic>
#include <span>
#include <string>
#include <vector>

#include "bench/harness/reference.hpp"
#include "bench/measure/probe_set.hpp"
#include "bench/measure/run_limits.hpp"
#include "bench/measure/run_one.hpp"
#include "case/scene.hpp"
#include "integrators/integrator.hpp"
#include "integrators/method_spec.hpp"
#include "results/results.hpp"

namespace superstep {

struct Verification {
  Outcome outcome;
  ProbeHistory history;  ///< of the run at the probes
  std::vector<FieldErrors>
      errors;  ///< one per field of the right-hand side; empty unless the run came to its end
};

/// Errors at output times, gathered while a run goes on, so that no state has to be kept.
class OutputErrors {
 public:
  /// Refers to both. Without a reference only overshoot is measured.
  OutputErrors(const Scene& scene, const Reference* reference);

  void observe(std::size_t output, double t, std::span<const double> state);
  /// What nobody can call a result, however small the error of one field is, makes the outcome
  /// `inaccurate`: a value out of its range, and the error of another field.
  ///   field  position of the one whose error is no matter here
  void judge_besides(std::size_t field, Outcome& outcome) const;

  [[nodiscard]] const std::vector<FieldErrors>& errors() const noexcept { return errors_; }
  [[nodiscard]] std::span<const double> last() const noexcept { return last_; }  ///< state observed

 private:
  const Scene& scene_;
  const Reference* reference_;
  std::vector<FieldErrors> errors_;  // one a field
  std::vector<double> last_;
};

/// Runs `spec` once, untimed, recording the probes. Without a reference only overshoot is measured. A run
/// whose error is beyond what anybody can call a result is `inaccurate`.
[[nodiscard]] Verification verify(const Scene& scene, const ProbeSet& probes, const MethodSpec& spec,
                                  const Reference* reference, const std::atomic<bool>* stop,
                                  Progress* progress, const RunLimits& limits = {});

/// What a tolerance allows a field: not less than a hundred roundings of its values [K or V].
[[nodiscard]] double allowed_error(const Scene& scene, const FieldView& field, double rtol, double span);

/// Values out of their range make the outcome `inaccurate`, of a run without a reference, too.
void judge_range(const Scene& scene, const RunResult& run, Outcome& outcome);

/// What a method delivered over what was asked for [-]; empty where the reference is not known well enough to
/// tell whether that is within ten times the tolerance.
///   rms      distance to the reference; bar  by how much the reference itself may be off; allowed  what was
///            asked for: all in the unit of the field
[[nodiscard]] Number delivered_error(double rms, double bar, double allowed);

/// An error that nobody should take for a result makes the outcome `inaccurate`.
///   unit  of the field
void judge(const FieldErrors& errors, const std::string& field, const std::string& unit, Outcome& outcome);

/// Errors at one probe of a run: mean over the transient's step ends and the decay fitted to them.
///   slot   position of the probe in both histories; t_end [s]
void measure_probe_errors(const ProbeHistory& run, const ProbeHistory& reference, std::size_t slot,
                          double t_end, FieldErrors& errors);

}  // namespace superstep
