#pragma once
/// A summary for continuous integration: the verdict first, then only what needs attention.

#include <string>

#include "results/results.hpp"

namespace superstep {

/// Markdown about one benchmark.
///   before  an earlier benchmark of the same cases, or null. With it only rows that changed are listed:
///   another
///           status, another number of steps or sweeps, an error that moved by more than 1 %, or CPU times
///           whose ranges do not overlap.
[[nodiscard]] std::string markdown_summary(const BenchReport& report, const BenchReport* before);

}  // namespace superstep
