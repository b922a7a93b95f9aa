#pragma once
/// Forward Euler's true critical step by bisection on actual runs, beside every estimate of it.
/// Source of the procedure: Rojek & Nisar 2026, Appendix A.1.

#include "bench/lab/mode.hpp"
#include "bench/lab/perturbation.hpp"
#include "case/checks/health.hpp"
#include "results/study/stability_results.hpp"

namespace superstep {

/// The limit is the longest step without growth (see GrowthMeter); no step at which the stiffest mode grows
/// is called stable.
[[nodiscard]] CriticalStepStudy study_critical_step(PerturbationRhs& rhs, const StiffestMode& mode,
                                                    const FieldHealth& health);

}  // namespace superstep
