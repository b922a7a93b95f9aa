#pragma once
/// results.json and run.json: everything that the CSV files hold, and what does not fit into a table.

#include <string>

#include "results/results.hpp"

namespace superstep {

/// results.json. The rows have the keys of the CSV columns; numbers that are not finite or not measured are
/// null.
[[nodiscard]] std::string results_json(const BenchReport& report);

/// run.json.
[[nodiscard]] std::string run_json(const RunRecord& record);

}  // namespace superstep
