#include "bench/measure/run_one.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include "bench/host/watchdog.hpp"
#include "bench/measure/range_watch.hpp"
#include "bench/measure/run_over.hpp"
#include "bench/measure/shared/shared_run.hpp"
#include "bench/measure/shared/shared_scene.hpp"
#include "rhs/one_way.hpp"

namespace superstep {
namespace {

/// A method that usually is faster than one of small steps.
std::string faster_method(Rhs& rhs, const MethodSpec& spec) {
  const std::string best = exactly_solvable(rhs) ? "exponential" : "rkc", other = "cvode";
  return spec.name() == best ? other : best;
}

/// What watches one run: its time, and what is to be said about it.
class Watch {
 public:
  Watch(const Scene& scene, const MethodSpec& spec, const RunRequest& request)
      : scene_(scene),
        spec_(spec),
        request_(request),
        dog_(request.limits.seconds, request.stop, request.limits.of_cpu) {
    if (request.progress && request.progress->watched()) reached_ = request.progress->watched();
  }

  [[nodiscard]] const std::atomic<bool>* flag() const noexcept { return dog_.flag(); }
  [[nodiscard]] std::atomic<double>* reached() noexcept { return reached_; }
  void stepping_begins() {
    if (!request_.limits.say) return;
    dog_.look_after(Watchdog::first_look, [this, faster = faster_method(*scene_.rhs, spec_)](double seconds) {
      const double part = reached_->load(std::memory_order_relaxed) / scene_.t_end;
      const std::string text = forecast_text(spec_.text(), part, seconds, request_.limits.seconds, faster);
      if (!text.empty()) request_.limits.say(text);
    });
  }
  /// A run that was stopped by us, and not by the user, has run out of time.
  [[nodiscard]] Outcome judged(Outcome outcome) const {
    if (outcome.status != Status::interrupted || !dog_.time_is_up()) return outcome;
    return {Status::timeout,
            fmt::format("not done after {:g} s of {} time: {}; allow it more with "
                        "--time-limit, or take another method",
                        request_.limits.seconds, request_.limits.of_cpu ? "CPU" : "wall", outcome.reason)};
  }

 private:
  const Scene& scene_;
  const MethodSpec& spec_;
  const RunRequest& request_;
  std::atomic<double> own_{0}, *reached_ = &own_;
  Watchdog dog_;  // last: its thread looks at what stands above
};

Plan plan_of(const Scene& scene, const MethodSpec& spec, const RunRequest& request, Watch& watch) {
  Plan plan = scene_plan(scene);
  plan.stop = watch.flag();
  plan.most_sweeps = request.limits.sweeps;
  plan.reached = watch.reached();
  // A method without a tolerance steps as it does alone, where nobody looks for spans on its behalf.
  if (spec.rtol() > 0) plan.spans = request.spans;
  plan.track_inflow = request.track_inflow;
  return plan;
}

/// One process with all of it.
Outcome run_alone(const Scene& scene, Plan plan, Integrator& method, const RunRequest& request,
                  std::function<void()> stepping_begins, RunResult& result) {
  if (request.probes && !request.probes->entries().empty()) {
    plan.probes = request.probes->entries();
    result.history = request.probes->history();
    plan.history = &result.history;
  }
  RunSite site{.rhs = *scene.rhs,
               .initial = scene.initial,
               .plan = std::move(plan),
               .observe = request.observe,
               .progress = request.progress,
               .stepping_begins = std::move(stepping_begins)};
  const RhsCounters before = scene.rhs->counters();
  Outcome outcome = run_over(site, method, result);
  count_work(before, *scene.rhs, result);
  take_facts(method, result);
  if (scene.rhs->size() == 0) result.t_reached = scene.t_end;
  return outcome;
}

/// What one process cannot share with others it does for them, up to a size.
Outcome run_gathered(const Scene& scene, Plan plan, Integrator& method, const RunRequest& request,
                     std::function<void()> stepping_begins, const std::string& why, RunResult& result) {
  constexpr std::size_t most = 2'000'000;  // unknowns: some GB of factors
  if (scene.own_nodes)
    return {Status::refused,
            fmt::format(
                "{}, and the scene is one of which nobody has the whole; take another method, or start the "
                "program once",
                why)};
  if (scene.rhs->size() > most)
    return {Status::refused,
            fmt::format("{}, and {} unknowns are more than the {} that are gathered on one process; take "
                        "another method, or start the program once",
                        why, scene.rhs->size(), most)};
  result.distributed = "gathered";
  return run_alone(scene, std::move(plan), method, request, std::move(stepping_begins), result);
}

/// Entries of a state are differences from the field's origin: taking it off inputs rounds, and so does
/// adding it to results.
void add_roundings_of_origins(const Scene& scene, RunResult& result) {
  if (!(result.statistics.error_bound > 0)) return;
  double most = 0;  // spans
  for (const auto& field : scene.fields) {
    if (field.view < 0 || field.origin == 0) continue;
    const double span = result.spans.at(static_cast<std::size_t>(field.view));
    const double largest = std::max(std::abs(field.low), std::abs(field.high)) + span;
    if (span > 0) most = std::max(most, std::numeric_limits<double>::epsilon() * largest / span);
  }
  result.statistics.error_bound += most;
  result.statistics.rounding_bound += most;
}

}  // namespace

RunResult run_one(const Scene& scene, const MethodSpec& spec, const RunRequest& wanted) {
  auto method = std::make_unique<Integrator>(spec.make());
  RunResult result;
  RunRequest request = wanted;
  RangeWatch range(scene);
  const bool sees_all = !scene.own_nodes;  // else each process looks at what it has
  if (wanted.watches_range && sees_all)
    request.observe = [&](std::size_t output, double t, std::span<const double> state) {
      range.observe(t, state);
      if (wanted.observe) wanted.observe(output, t, state);
    };
  Watch watch(scene, spec, request);
  Plan plan = plan_of(scene, spec, request, watch);
  const auto stepping_begins = [&] { watch.stepping_begins(); };
  Outcome outcome;
  if (world().alone()) {
    outcome = run_alone(scene, std::move(plan), *method, request, stepping_begins, result);
  } else if (!can_be_shared(scene)) {
    outcome = run_gathered(scene, std::move(plan), *method, request, stepping_begins,
                           "the scene is not one that processes share", result);
  } else {
    try {
      outcome = run_shared(scene, spec.text(), plan, request, stepping_begins, result);
    } catch (const NeedsWhole& whole) {
      method = std::make_unique<Integrator>(spec.make());
      result = {};
      outcome = run_gathered(scene, std::move(plan), *method, request, stepping_begins, whole.what(), result);
    }
  }
  result.outcome = watch.judged(std::move(outcome));
  if (wanted.watches_range && sees_all) result.overshoot = range.overshoot();
  add_roundings_of_origins(scene, result);
  return result;
}

Plan scene_plan(const Scene& scene) {
  Plan plan;
  plan.output_times = scene.output_times;
  for (const auto& field : scene.rhs->fields())
    plan.ranges.push_back(scene_field(scene, field.name).range_of_state());
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
