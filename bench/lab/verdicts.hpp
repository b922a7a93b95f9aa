#pragma once
/// Where each method is safe and where not, from the numbers that the laboratory measured.

#include <vector>

#include "results/study/stability_results.hpp"

namespace superstep {

[[nodiscard]] std::vector<Verdict> judge_methods(const StabilityResults& results);

}  // namespace superstep
