#pragma once
/// results.csv: one line per case and integrator.

#include <span>
#include <string>

#include "results/results.hpp"

namespace superstep {

[[nodiscard]] std::string results_csv(std::span<const BenchCase> cases);

}  // namespace superstep
