#include "bench/lab/frozen/states_of_run.hpp"

#include <fmt/format.h>

#include "bench/measure/run_one.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

constexpr double parts[] = {0.1, 0.5, 1};  // of t_end, after the start

void add_later_states(const Scene& scene, StatesOfRun& out) {
  Plan plan = scene_plan(scene);
  plan.output_times.clear();
  for (const double part : parts) plan.output_times.push_back(part * scene.t_end);
  plan.spans = out.spans;
  plan.settle_tolerance = 0;  // states of every field
  const auto method = make_integrator(method_of_states);
  const auto missing = [&](double part, const std::string& reason) {
    out.notes.push_back(fmt::format("no states from {:g} % of t_end on: {} did not get there: {}", 100 * part,
                                    method_of_states, reason));
  };
  try {
    method->prepare(*scene.rhs, plan);
    method->start(0, scene.initial);
  } catch (const Refused& refusal) {
    return missing(parts[0], refusal.what());
  }
  for (std::size_t k = 0; k < plan.output_times.size(); ++k) {
    if (const auto outcome = method->advance(plan.output_times[k]); !outcome.ok())
      return missing(parts[k], outcome.reason);
    const auto y = method->state();
    out.states.push_back({parts[k], plan.output_times[k], {y.begin(), y.end()}});
  }
}

}  // namespace

StatesOfRun states_along_run(const Scene& scene) {
  StatesOfRun out;
  if (scene.rhs->size() == 0) return out;
  out.spans = scene_spans(scene).spans;
  out.states.push_back({0, 0, scene.initial});
  if (!scene.rhs->traits().constant_jacobian) add_later_states(scene, out);
  return out;
}

}  // namespace superstep
