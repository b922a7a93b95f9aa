#pragma once
/// results.csv: one line per case and integrator.

#include <span>
#include <string>

#include "reports/results.hpp"

namespace superstep {

[[nodiscard]] std::string results_csv(std::span<const BenchCase> cases);

}  // namespace superstep
