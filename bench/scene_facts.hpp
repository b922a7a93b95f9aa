#pragma once
/// What reports say about a scene.

#include <cstddef>
#include <vector>

#include "reports/results.hpp"
#include "scene/scene.hpp"

namespace superstep {

/// Field of the right-hand side that the main columns speak of: the temperature when there is one, else the
/// only field.
[[nodiscard]] std::size_t main_field(const Rhs& rhs) noexcept;

/// The scene's skips as the reports know them.
[[nodiscard]] std::vector<SkippedWork> skipped_work(const Scene& scene);

}  // namespace superstep
