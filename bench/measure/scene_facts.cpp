#include "bench/measure/scene_facts.hpp"

#include <fmt/format.h>

namespace superstep {

std::size_t main_field(const Rhs& rhs) noexcept {
  const auto fields = rhs.fields();
  for (std::size_t f = 0; f < fields.size(); ++f)
    if (fields[f].name == "temperature") return f;
  return 0;
}

std::vector<SkippedWork> skipped_work(const Scene& scene) {
  std::vector<SkippedWork> out;
  for (const auto& skip : scene.skips) out.push_back({skip.what, skip.because});
  return out;
}

std::vector<SkippedWork> skipped_work(const Scene& scene, const RunResult& run) {
  auto out = skipped_work(scene);
  if (run.settled_at)
    out.push_back({fmt::format("stepping the potential from t = {:.4g} s on", *run.settled_at),
                   fmt::format("it was steady: what was left of its change moves no field by a tenth of the "
                               "tolerance, or by [electric] settle_tolerance = {:g} of its span",
                               scene.settle_tolerance)});
  if (run.jacobians == 1 && run.statistics.steps > 1 && scene.rhs->traits().constant_jacobian)
    out.push_back({"repeated Jacobians", "conductances are constant: one evaluation a run"});
  if (run.jacobians == 0 && run.statistics.steps > 0) out.push_back({"matrices", "the method needs none"});
  return out;
}

}  // namespace superstep
