#pragma once
/// Folders of `superstep run`, read for a report.

#include <string>
#include <vector>

#include "reports/html/report_input.hpp"

namespace superstep {

/// Runs in `folder` itself and one level below, by name. Throws InputError for broken files.
[[nodiscard]] std::vector<RunInput> read_runs(const std::string& folder);

}  // namespace superstep
