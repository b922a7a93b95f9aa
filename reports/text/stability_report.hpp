#pragma once
/// What `superstep stability` prints.

#include <string>

#include "results/study/stability_results.hpp"

namespace superstep {

/// Sections with aligned tables, and a verdict per method at the end.
[[nodiscard]] std::string stability_text(const StabilityResults& results, bool color);

}  // namespace superstep
