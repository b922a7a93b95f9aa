#include "bench/measure/range_watch.hpp"

#include <algorithm>

#include "bench/measure/metrics.hpp"
#include "bench/measure/run_one.hpp"

namespace superstep {

double overshoot_at(const Scene& scene, std::size_t field, double t, std::span<const double> state) {
  const FieldView& view = scene.rhs->fields()[field];
  const FieldRange declared = scene_field(scene, view.name).range_of_state();
  const FieldRange range = attainable_range(declared, scene.rhs->facts().fields[field], t);
  return overshoot(view, state, range.low, range.high);
}

RangeWatch::RangeWatch(const Scene& scene) : scene_(scene), overshoot_(scene.rhs->fields().size(), 0.0) {}

void RangeWatch::observe(double t, std::span<const double> state) {
  for (std::size_t f = 0; f < overshoot_.size(); ++f)
    overshoot_[f] = std::max(overshoot_[f], overshoot_at(scene_, f, t, state));
}

}  // namespace superstep
