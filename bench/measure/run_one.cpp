#include "bench/measure/run_one.hpp"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <utility>

#include "bench/host/watchdog.hpp"
#include "bench/measure/counted.hpp"
#include "core/error.hpp"
#include "core/stopwatch.hpp"
#include "rhs/one_way.hpp"

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

constexpr double first_look = 10;  // s after which a forecast is worth something

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
    dog_.look_after(first_look, [this, faster = faster_method(*scene_.rhs, spec_)](double seconds) {
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

/// A method whose number of steps is known is not begun when it is too much.
Outcome affordable(const Plan& plan, const Statistics& statistics) {
  if (plan.most_sweeps == 0 || !(statistics.time_per_sweep > 0)) return {};
  const double sweeps = (plan.output_times.back() - plan.t_begin) / statistics.time_per_sweep;
  if (sweeps <= static_cast<double>(plan.most_sweeps)) return {};
  return {Status::refused,
          fmt::format("it would take {:.3g} sweeps over the network, and {} are allowed; allow "
                      "more with --max-work, or take another method",
                      sweeps, plan.most_sweeps)};
}

Plan plan_of(const Scene& scene, const RunRequest& request, Watch& watch, RunResult& result) {
  Plan plan = scene_plan(scene);
  plan.stop = watch.flag();
  plan.most_sweeps = request.limits.sweeps;
  plan.reached = watch.reached();
  plan.spans = result.spans;
  plan.track_inflow = request.track_inflow;
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
      Outcome outcome;
      counted([&] { outcome = method.advance(t); });
      if (!outcome.ok()) return outcome;
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

Outcome integrate(const Scene& scene, Integrator& method, const RunRequest& request, Watch& watch,
                  RunResult& result) {
  try {
    if (scene.rhs->size() == 0) return nothing_to_integrate(scene, request, result);
    result.spans = request.spans;
    if (result.spans.empty() && method.rtol() > 0) {
      double wall = 0;  // not asked for
      const Timer timer(result.cpu_pilot, wall);
      result.spans = scene_spans(scene, watch.flag()).spans;
    }
    const Plan plan = plan_of(scene, request, watch, result);
    {
      const Timer timer(result.cpu_prepare, result.wall_prepare);
      method.prepare(*scene.rhs, plan);
    }
    {
      const Timer timer(result.cpu_stepping, result.wall_stepping);
      counted([&] { method.start(plan.t_begin, scene.initial); });
    }
    if (Outcome outcome = affordable(plan, method.statistics()); !outcome.ok()) return outcome;
    watch.stepping_begins();
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

RunResult run_one(const Scene& scene, const MethodSpec& spec, const RunRequest& request) {
  const auto method = std::make_unique<Integrator>(spec.make());
  RunResult result;
  const RhsCounters before = scene.rhs->counters();
  {
    Watch watch(scene, spec, request);
    Outcome outcome = integrate(scene, *method, request, watch, result);
    result.outcome = watch.judged(std::move(outcome));
  }
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
