#pragma once
/// history.csv and the snapshots of a run of moving particles.

#include <optional>
#include <string>

#include "results/motion_input.hpp"

namespace superstep {

/// Empty when `folder` holds the run of a fixed network. Throws InputError for broken files.
[[nodiscard]] std::optional<MotionInput> read_motion(const std::string& folder);

}  // namespace superstep
