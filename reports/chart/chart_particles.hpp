#pragma once
/// Pictures of moving particles in the box of their press.

#include <string>

#include "results/motion_input.hpp"

namespace superstep {

/// One small picture per frame, all on one scale and one scale of colours: by temperature, and by current or
/// potential where there was any. Empty without frames.
///   id  of the first figure; the second one's has "-electric" behind it
[[nodiscard]] std::string particles_figures(const MotionInput& motion, const std::string& id);

}  // namespace superstep
