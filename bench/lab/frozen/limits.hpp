#pragma once
/// Stability limits of a scene that is frozen at a state: predicted from eigenvalues, measured by growth.

#include <functional>

#include "bench/host/progress.hpp"
#include "bench/lab/frozen/frozen_rhs.hpp"
#include "case/scene.hpp"
#include "results/study/stability_results.hpp"

namespace superstep {

/// What one frozen state allows: its eigenvalues, and the limits of forward Euler, STS and stabilised
/// families.
///   done  called after each method
[[nodiscard]] FrozenState find_limits(FrozenRhs& rhs, bool quick, const std::function<void()>& done = {});

/// Freezes the scene at its start and at states along a run of it, and finds the limits there. States without
/// a Jacobian, or with that of an earlier one, are left out and noted.
void study_frozen_states(const Scene& scene, bool quick, Progress& progress, StabilityResults& results);

}  // namespace superstep
