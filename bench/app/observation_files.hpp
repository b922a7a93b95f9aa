#pragma once
/// Files of a benchmark that only its report reads.

#include <span>
#include <string>
#include <vector>

#include "bench/app/loaded_case.hpp"
#include "results/results.hpp"

namespace superstep {

/// Writes histories.csv, snapshots.csv and, of scenes, health.json into `folder`, and removes those of an
/// earlier benchmark that have no successor. Throws OutputError.
///   loaded  the cases of `report.cases`, in the same order; there may be more of them
void write_observation_files(const std::string& folder, const BenchReport& report,
                             std::span<const LoadedCase> loaded);

/// Removes those of an earlier benchmark.
void remove_observation_files(const std::string& folder);

}  // namespace superstep
