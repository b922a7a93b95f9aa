#pragma once
/// histories.csv and snapshots.csv: what the charts of a report need and results.json does not hold.

#include <map>
#include <span>
#include <string>

#include "results/results.hpp"

namespace superstep {

/// histories.csv: one row per case, method, probe and instant.
[[nodiscard]] std::string histories_csv(std::span<const BenchCase> cases);
/// snapshots.csv: one row per case, field, time and sphere of the slice.
[[nodiscard]] std::string snapshots_csv(std::span<const BenchCase> cases);

/// Both files of `folder` as far as they exist, by case name. Throws InputError for broken ones.
[[nodiscard]] std::map<std::string, CaseObservations> read_observations(const std::string& folder);

}  // namespace superstep
