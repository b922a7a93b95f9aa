#pragma once
/// Whether two benchmarks measured the same case.

#include <string>

#include "results/results.hpp"

namespace superstep {

/// The first fact that tells two cases of one name apart: a size, a time or the unit of errors.
///   returns  "nodes = 7, and 20"; empty where there is none
[[nodiscard]] std::string difference_of(const BenchCase& one, const BenchCase& other);

}  // namespace superstep
