#pragma once
/// What the registered methods say about their stability, all together.

#include <vector>

#include "integrators/schemes/stability_model.hpp"

namespace superstep {

/// To compare step by step with what is measured.
[[nodiscard]] std::vector<StabilityModel> stability_functions(bool quick);
/// Those whose longest stable step is measured at every frozen state.
[[nodiscard]] std::vector<StabilityModel> stability_limits(bool quick);

}  // namespace superstep
