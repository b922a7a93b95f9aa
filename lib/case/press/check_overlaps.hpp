#pragma once
/// How far particles of a press overlap each other and the walls before anything has moved.

#include <optional>
#include <string>

#include "case/press/read_model.hpp"

namespace superstep::dynamics {

/// Throws InputError that names the deepest overlap, if that exceeds the limit.
///   allowed  max_overlap, of the sum of two radii or of the radius of one at a wall; empty = none was given:
///   they may
///            touch
///   place    of the particles in the case
void check_overlaps(const ModelInput& input, std::optional<double> allowed, const std::string& place);

}  // namespace superstep::dynamics
