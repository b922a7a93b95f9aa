#pragma once
/// What reports say about a scene.

#include <cstddef>
#include <vector>

#include "bench/measure/run_one.hpp"
#include "case/scene.hpp"
#include "results/results.hpp"

namespace superstep {

/// Field of the right-hand side that the main columns speak of: the temperature when there is one, else the
/// only field.
[[nodiscard]] std::size_t main_field(const Rhs& rhs) noexcept;

/// The scene's skips as the reports know them: what no method does.
[[nodiscard]] std::vector<SkippedWork> skipped_work(const Scene& scene);
/// With what this run did not do.
[[nodiscard]] std::vector<SkippedWork> skipped_work(const Scene& scene, const RunResult& run);

}  // namespace superstep
