#pragma once
/// Thermal integrators side by side along one and the same motion.
///
/// Every method carries temperatures of its own from contact update to contact update, over the frozen
/// networks that the motion passes through; the motion itself follows the case's own settings. So all see the
/// same networks, and errors add up as they would in a run.

#include <string>
#include <vector>

#include "bench/harness/harness.hpp"
#include "bench/host/progress.hpp"
#include "integrators/press/sintering_case.hpp"
#include "results/results.hpp"

namespace superstep {

/// Rows of errors against `reference` (worst over the output times), work, and CPU time of preparation and
/// stepping, summed over all contact updates; building the networks is not part of it. Each update is done
/// `options.repetitions` times by each method in turn. A method that fails is out from then on.
[[nodiscard]] BenchCase bench_thermal_lanes(const dynamics::SinteringCase& one, const HarnessOptions& options,
                                            Progress& progress);

}  // namespace superstep
