#pragma once
/// The terminal's view of one case of a benchmark.

#include <string>

#include "results/results.hpp"

namespace superstep {

/// Heading, one line per integrator (fastest first, preparation included), the answer in one sentence, and
/// below what methods chose and why others failed. An error below the reference's error bar is shown as
/// "<bar": it could as well be the reference's own.
[[nodiscard]] std::string results_table(const BenchCase& one, int repetitions, int threads, bool color);

}  // namespace superstep
