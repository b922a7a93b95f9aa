#pragma once
/// Values outside the ranges that users have, and packings that look wrong: said, never silently accepted.

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace superstep {

/// One sentence per finding; empty for a healthy scene.
[[nodiscard]] std::vector<std::string> range_warnings(const Scene& scene);

}  // namespace superstep
