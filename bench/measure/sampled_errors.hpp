#pragma once
/// Errors at a probe by the rule of a published table, see SampledMeasure.
///
/// Source of the rule: Rojek & Nisar 2026, eqs 42-47: the output of forward Euler is subtracted from that of
/// super-time-stepping, instant by instant, over the interval of the fit.

#include <optional>
#include <span>
#include <vector>

#include "bench/measure/probe_set.hpp"
#include "results/results.hpp"

namespace superstep {

/// from, from + every, ..., to [s].
[[nodiscard]] std::vector<double> sampling_instants(const SampledMeasure& measure);

/// Values at a probe as a code writes them that looks at the end of each step whether an output is due: those
/// of the first step ends at or after the instants. Empty when the history ends before the last instant.
///   slot  position of the probe; instants  ascending [s];  rounding  how far before an instant a step end
///   still is at it [s]
[[nodiscard]] std::vector<double> written_values(const ProbeHistory& history, std::size_t slot,
                                                 std::span<const double> instants, double rounding);

/// Values at the instants themselves; empty when the history ends before the last one.
[[nodiscard]] std::vector<double> values_at(const ProbeHistory& history, std::size_t slot,
                                            std::span<const double> instants, double rounding);

/// Mean |value - subtracted| and its decay over the instants.
void measure_samples(std::span<const double> instants, std::span<const double> values,
                     std::span<const double> subtracted, FieldErrors& errors);

/// The rule applied to the runs of one benchmark: what to keep of each run, and what to make of it when all
/// have been run.
class SampledErrors {
 public:
  /// Measures nothing without a rule, or when its field has no probe whose value may change.
  SampledErrors(const std::optional<SampledMeasure>& measure, const ProbeSet& probes);

  /// Empty when nothing is measured or the run is shorter than the rule's window.
  [[nodiscard]] std::vector<double> samples(const ProbeHistory& history) const;
  /// Nothing is set when either has no samples.
  void measure(std::span<const double> samples, std::span<const double> subtracted,
               FieldErrors& errors) const;

 private:
  std::optional<SampledMeasure> measure_;
  std::vector<double> instants_;
  std::size_t slot_ = 0;
};

}  // namespace superstep
