#pragma once
/// The stability laboratory: where each method is safe on a scene, by theory and by measurement.

#include "bench/host/progress.hpp"
#include "case/scene.hpp"
#include "results/study/stability_results.hpp"

namespace superstep {

/// Limits at states along a run, rounding and random networks for every scene; stability functions and
/// estimates of the critical step, too, for one whose modes never change (linear and symmetric). A verdict
/// per method. `quick` = coarser sets, for tests.
[[nodiscard]] StabilityResults run_stability_lab(const Scene& scene, bool quick, Progress& progress);

/// True when everything that must agree does: theory and measurement (natural order of STS excepted, which
/// loses its digits), bisection and Lanczos, limits predicted and
/// measured, and the safe orders of STS.
[[nodiscard]] bool is_consistent(const StabilityResults& results);

}  // namespace superstep
