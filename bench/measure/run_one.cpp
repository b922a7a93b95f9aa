#include "bench/measure/run_one.hpp"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "core/error.hpp"
#include "core/stopwatch.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

/// Adds the time between its construction and `stop` to a pair of sums.
class Timer {
 public:
  Timer(double& cpu, double& wall) : cpu_(cpu), wall_(wall) {}
  ~Timer() {
    cpu_ += process_cpu_seconds() - cpu_begin_;
    wall_ += wall_seconds() - wall_begin_;
  }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

 private:
  double &cpu_, &wall_;
  double wall_begin_ = wall_seconds(), cpu_begin_ = process_cpu_seconds();
};

Plan plan_of(const Scene& scene, const RunRequest& request, RunResult& result) {
  Plan plan = scene_plan(scene);
  plan.stop = request.stop;
  plan.spans = result.spans;
  plan.track_inflow = request.track_inflow;
  if (request.progress) plan.reached = request.progress->watched();
  if (request.probes && !request.probes->entries().empty()) {
    plan.probes = request.probes->entries();
    result.history = request.probes->history();
    plan.history = &result.history;
  }
  return plan;
}

Outcome advance_over_outputs(const Scene& scene, Integrator& method, const RunRequest& request,
                             RunResult& result) {
  for (std::size_t k = 0; k < scene.output_times.size(); ++k) {
    const double t = scene.output_times[k];
    {
      const Timer timer(result.cpu_stepping, result.wall_stepping);
      if (Outcome outcome = method.advance(t); !outcome.ok()) return outcome;
    }
    if (request.progress) request.progress->reached(t);
    if (request.observe) request.observe(k, t, method.state());
  }
  return {};
}

/// A steady field alone was solved for when the scene was built.
Outcome nothing_to_integrate(const Scene& scene, const RunRequest& request, RunResult& result) {
  for (std::size_t k = 0; k < scene.output_times.size() && request.observe; ++k)
    request.observe(k, scene.output_times[k], {});
  result.choice = "nothing to integrate: the field is steady and was solved for";
  return {};
}

Outcome integrate(const Scene& scene, Integrator& method, const RunRequest& request, RunResult& result) {
  try {
    if (scene.rhs->size() == 0) return nothing_to_integrate(scene, request, result);
    result.spans = request.spans;
    if (result.spans.empty() && method.rtol() > 0) {
      double wall = 0;  // not asked for
      const Timer timer(result.cpu_pilot, wall);
      result.spans = scene_spans(scene, request.stop).spans;
    }
    const Plan plan = plan_of(scene, request, result);
    {
      const Timer timer(result.cpu_prepare, result.wall_prepare);
      method.prepare(*scene.rhs, plan);
    }
    {
      const Timer timer(result.cpu_stepping, result.wall_stepping);
      method.start(plan.t_begin, scene.initial);
    }
    return advance_over_outputs(scene, method, request, result);
  } catch (const Refused& refused) {
    return {Status::refused, refused.what()};
  } catch (const std::bad_alloc&) {
    return {Status::failed, "out of memory"};
  } catch (const Error& error) {
    // A file that cannot be written is no fault of the method.
    if (error.code() != ExitCode::numerical) throw;
    return {Status::failed, error.what()};
  } catch (const std::exception& error) {
    return {Status::failed, error.what()};
  }
}

}  // namespace

RunResult run_one(const Scene& scene, const std::string& spec, const RunRequest& request) {
  const auto method = make_integrator(spec);
  RunResult result;
  const RhsCounters before = scene.rhs->counters();
  result.outcome = integrate(scene, *method, request, result);
  const RhsCounters after = scene.rhs->counters();
  result.sweeps = after.sweeps - before.sweeps;
  result.jacobians = after.jacobians - before.jacobians;
  result.statistics = method->statistics();
  result.t_reached = scene.rhs->size() == 0 ? scene.t_end : method->time();
  if (scene.rhs->size() > 0) result.choice = method->choice();
  result.potential_solves = after.potential_solves - before.potential_solves;
  result.settled_at = method->settled_at();
  return result;
}

Plan scene_plan(const Scene& scene) {
  Plan plan;
  plan.output_times = scene.output_times;
  for (const auto& field : scene.rhs->fields()) {
    const auto& described = scene_field(scene, field.name);
    plan.ranges.push_back({described.low, described.high});
  }
  plan.settle_tolerance = scene.settle_tolerance;
  return plan;
}

Spans scene_spans(const Scene& scene, const std::atomic<bool>* stop) {
  Plan plan = scene_plan(scene);
  plan.stop = stop;
  return find_spans(*scene.rhs, plan, 0, scene.initial);
}

const FieldScene& scene_field(const Scene& scene, const std::string& name) {
  for (const auto& field : scene.fields)
    if (field.name == name) return field;
  throw std::logic_error(
      fmt::format("the right-hand side has a field '{}' that the scene does not describe", name));
}

}  // namespace superstep
