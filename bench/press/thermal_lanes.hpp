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
#include "case/press/press.hpp"
#include "results/results.hpp"

namespace superstep {

/// What errors are measured against unless somebody says otherwise. Between contact updates the network is
/// linear and constant: the exponential is exact there, whereas the small errors of a method that starts anew
/// after every update add up.
inline constexpr const char* reference_of_lanes = "exponential:basis=chebyshev,rtol=1e-12";

/// Rows of errors against the reference (worst over the output times), work, and CPU time of preparation and
/// stepping, summed over all contact updates; building the networks is not part of it. Each update is done
/// `options.repetitions` times by each method in turn. A method that fails is out from then on.
///   cpu_setup [s]  CPU time that reading the case took
[[nodiscard]] BenchCase bench_thermal_lanes(const Press& one, double cpu_setup, const HarnessOptions& options,
                                            Progress& progress);

}  // namespace superstep
