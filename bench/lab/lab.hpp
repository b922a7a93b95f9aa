#pragma once
/// The stability laboratory: where each method is safe on a scene, by theory and by measurement.

#include "bench/host/progress.hpp"
#include "case/scene.hpp"
#include "results/study/stability_results.hpp"

namespace superstep {

/// Four experiments and a verdict per method. `quick` = coarser sets, for tests. Throws InputError for a
/// scene without modes (not linear and symmetric).
[[nodiscard]] StabilityResults run_stability_lab(const Scene& scene, bool quick, Progress& progress);

/// True when everything that must agree does: theory and measurement (natural order of STS excepted, which
/// loses its digits), bisection and Lanczos, and the safe orders of STS.
[[nodiscard]] bool is_consistent(const StabilityResults& results);

}  // namespace superstep
