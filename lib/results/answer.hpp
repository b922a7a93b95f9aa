#pragma once
/// The question of the program, answered from the rows of one case.

#include <string>

#include "results/results.hpp"

namespace superstep {

/// Median CPU time of preparation and stepping together [s]; empty where it was not measured.
[[nodiscard]] Number prepared_cpu(const BenchRow& row);

/// Largest rms error of a row over its fields, relative to the span of each; empty where it was not measured.
[[nodiscard]] Number relative_error(const BenchRow& row);

/// The row that takes least (prepared_cpu) of those that ended well with an error up to `level`, as far as
/// the reference can tell; null where there is none.
[[nodiscard]] const BenchRow* fastest_within(const BenchCase& one, double level);

/// One sentence: the fastest method with an error below 1e-3 of the span, else below 1e-2 or 1e-1, and how
/// much faster it is than the baseline and than CVODE with KLU. Says which methods cannot be told apart from
/// it. Says so where nothing was timed; empty where errors were not measured.
[[nodiscard]] std::string answer_text(const BenchCase& one);

}  // namespace superstep
