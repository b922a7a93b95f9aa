#pragma once
/// What bonds of a file do at the start.

#include <optional>
#include <string>

#include "case/press/read_model.hpp"

namespace superstep::dynamics {

/// A warning where bonds are stretched beyond what they hold, so that the first step breaks them: that of the
/// bond that is stretched most, with its strain. Nothing where all hold.
///   path  of the file that they stand in
[[nodiscard]] std::optional<std::string> torn_bonds(const ModelInput& input, const std::string& path);

}  // namespace superstep::dynamics
