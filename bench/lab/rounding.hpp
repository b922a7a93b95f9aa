#pragma once
/// Rounding growth inside supersteps: three orders of the same substeps.

#include <vector>

#include "results/study/stability_results.hpp"

namespace superstep {

/// Every order for growing n and three dampings, on a chain whose modes are known in closed form, so that
/// both the exact superstep and the exact solution can be written down and what remains is rounding.
[[nodiscard]] std::vector<RoundingGrowth> study_rounding(bool quick);

/// Largest factor by which one rounding inside a superstep can grow, over all rates up to the limit:
///   recurrence    from any stage to the end, through the recurrence
///   leja, natural the largest product of leading or of trailing substeps
[[nodiscard]] double internal_amplification(int n, double nu, const std::string& order);

}  // namespace superstep
