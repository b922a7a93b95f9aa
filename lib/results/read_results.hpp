#pragma once
/// results.json and run.json, read back.

#include <string>

#include "results/results.hpp"

namespace superstep {

/// Reads a results.json of the schema that `results_json` writes; unknown keys are left alone, missing ones
/// are empty. Throws InputError for anything that is not such a file or has a newer schema.
[[nodiscard]] BenchReport read_results_json(const std::string& path);

/// The same for a run.json.
[[nodiscard]] RunRecord read_run_json(const std::string& path);

}  // namespace superstep
