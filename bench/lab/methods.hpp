#pragma once
/// Stability functions against growth measured on the network.

#include <span>

#include "bench/lab/catalogue.hpp"
#include "bench/lab/mode.hpp"
#include "bench/lab/perturbation.hpp"
#include "results/study/stability_results.hpp"

namespace superstep {

/// Theory of one method, and three measurements on the network:
///   - steps of several lengths up to the method's own, from the stiffest mode: R(z) point by point
///   - a white perturbation at the method's own step: its growth must stay below max |R|
///   - a white perturbation at a step beyond the limit, where |R| = 2: it must double in each step
[[nodiscard]] MethodStability examine_method(PerturbationRhs& rhs, const StiffestMode& mode,
                                             const StabilityModel& method);

}  // namespace superstep
