#pragma once
/// What `superstep info` prints.

#include <string>

#include "case/checks/health.hpp"
#include "case/scene.hpp"

namespace superstep {

/// Sections for a person; figures of the source, when the case states them, stand beside ours.
[[nodiscard]] std::string health_text(const Scene& scene, const NetworkHealth& health);
/// The same as one JSON object.
[[nodiscard]] std::string health_json(const Scene& scene, const NetworkHealth& health);

}  // namespace superstep
