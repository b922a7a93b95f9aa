#pragma once
/// Pictures of moving particles in the box of their press.

#include <string>

#include "results/motion_input.hpp"

namespace superstep {

/// One small picture per frame, all on one scale and one scale of colours; empty without frames.
///   id  of the figure
[[nodiscard]] std::string particles_figure(const MotionInput& motion, const std::string& id);

}  // namespace superstep
