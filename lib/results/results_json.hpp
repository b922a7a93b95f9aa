#pragma once
/// results.json and run.json, written and read: everything that the CSV files hold, and what does not fit
/// into a table. Their keys are listed in schema/bench_fields.cpp and schema/run_fields.cpp.

#include <string>

#include "results/results.hpp"

namespace superstep {

inline constexpr const char* schema_of_results = "superstep.results";
inline constexpr const char* schema_of_runs = "superstep.run";
/// Raised when a key changes its meaning or goes; new keys alone do not raise it.
constexpr int results_schema_version = 1;

/// results.json. The rows have the keys of the CSV columns; numbers that are not finite or not measured are
/// null.
[[nodiscard]] std::string results_json(const BenchReport& report);
/// run.json.
[[nodiscard]] std::string run_json(const RunRecord& record);

/// Reads a results.json; unknown keys are left alone, missing ones are empty. Throws InputError for anything
/// that is not such a file, has another version, or holds what was never measured: a negative time or error,
/// a status that there is not, two rows of one method.
[[nodiscard]] BenchReport read_results_json(const std::string& path);
/// The same for a run.json.
[[nodiscard]] RunRecord read_run_json(const std::string& path);

}  // namespace superstep
