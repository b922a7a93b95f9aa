#pragma once
/// Verification of one integrator against the reference, before anything is timed.

#include <atomic>
#include <span>
#include <string>
#include <vector>

#include "bench/probe_set.hpp"
#include "bench/reference.hpp"
#include "integrators/integrator.hpp"
#include "reports/results.hpp"
#include "scene/scene.hpp"

namespace superstep {

struct Verification {
  Outcome outcome;
  ProbeHistory history;             ///< of the run at the probes
  std::vector<FieldErrors> errors;  ///< one per field of the right-hand side; empty unless the outcome is ok
};

/// Runs `spec` once, untimed, tracking what enters and the probes. Without a reference only overshoot and
/// balance are measured.
[[nodiscard]] Verification verify(const Scene& scene, const ProbeSet& probes, const std::string& spec,
                                  const Reference* reference, const std::atomic<bool>* stop,
                                  Progress* progress);

/// Errors at one probe of a run: mean over the transient's step ends and the decay fitted to them.
///   slot   position of the probe in both histories; t_end [s]
void measure_probe_errors(const ProbeHistory& run, const ProbeHistory& reference, std::size_t slot,
                          double t_end, FieldErrors& errors);

}  // namespace superstep
