#pragma once
/// The part of a run that is the same for one process that has the whole scene and for many that share it.

#include <span>
#include <string>

#include "bench/measure/run_one.hpp"
#include "integrators/driver.hpp"

namespace superstep {

/// Where and over what a method is run.
struct RunSite {
  Rhs& rhs;
  std::span<const double> initial;
  /// Output times, ranges and spans, probes, limits, stop; `history` is set where probes are recorded.
  Plan plan;
  const std::function<void(std::size_t output, double t, std::span<const double> state)>& observe;
  Progress* progress = nullptr;
  std::function<void()> stepping_begins = {};
};

/// Why a run failed that found no memory.
inline constexpr const char* out_of_memory = "out of memory";

/// Everything from the pilot run to the last output. Adds times to `result`.
[[nodiscard]] Outcome run_over(RunSite& site, Integrator& method, RunResult& result);

/// Work that a run took since `before`, without that of its pilot run.
void count_work(const RhsCounters& before, const Rhs& rhs, RunResult& result);

/// What the method says of a run that is over.
void take_facts(const Integrator& method, RunResult& result);

}  // namespace superstep
