#pragma once
/// Forward Euler's true critical step by bisection on actual runs, beside every estimate of it.
/// Source of the procedure: Rojek & Nisar 2026, Appendix A.1.

#include "bench/lab/perturbation.hpp"
#include "case/checks/health.hpp"
#include "results/study/stability_results.hpp"

namespace superstep {

/// A run is 2000 steps of forward Euler from a rough perturbation within [-1, 1]; it is unstable when a value
/// leaves
/// [-3, 3], which takes growth. A step 0.2 % beyond the limit does that, so the limit comes out up to that
/// much too long.
[[nodiscard]] CriticalStepStudy study_critical_step(PerturbationRhs& rhs, const FieldHealth& health);

}  // namespace superstep
