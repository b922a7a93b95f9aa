#include "bench/measure/run_over.hpp"

#include <fmt/format.h>

#include <new>
#include <stdexcept>

#include "bench/measure/counted.hpp"
#include "core/error.hpp"
#include "core/stopwatch.hpp"

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

Outcome advance_over_outputs(RunSite& site, Integrator& method, RunResult& result) {
  const auto& times = site.plan.output_times;
  for (std::size_t k = 0; k < times.size(); ++k) {
    {
      const Timer timer(result.cpu_stepping, result.wall_stepping);
      Outcome outcome;
      counted([&] { outcome = method.advance(times[k]); });
      if (!outcome.ok()) return outcome;
    }
    if (site.progress) site.progress->reached(times[k]);
    if (site.observe) site.observe(k, times[k], method.state());
  }
  return {};
}

/// A steady field alone was solved for when the scene was built.
Outcome nothing_to_integrate(RunSite& site, RunResult& result) {
  const auto& times = site.plan.output_times;
  for (std::size_t k = 0; k < times.size() && site.observe; ++k) site.observe(k, times[k], {});
  result.choice = "nothing to integrate: the field is steady and was solved for";
  return {};
}

Outcome run_through(RunSite& site, Integrator& method, RunResult& result) {
  if (site.rhs.reduction().total() == 0) return nothing_to_integrate(site, result);
  Plan& plan = site.plan;
  if (plan.spans.empty() && method.rtol() > 0) {
    double wall = 0;  // not asked for
    const Timer timer(result.cpu_pilot, wall);
    Plan pilot = plan;  // its history, work and progress are nobody's business
    pilot.probes.clear();
    pilot.history = nullptr;
    pilot.most_sweeps = 0;
    pilot.reached = nullptr;
    const RhsCounters before = site.rhs.counters();
    plan.spans = find_spans(site.rhs, pilot, plan.t_begin, site.initial).spans;
    result.pilot_work = difference(site.rhs.counters(), before);
  }
  result.spans = plan.spans;
  {
    const Timer timer(result.cpu_prepare, result.wall_prepare);
    method.prepare(site.rhs, plan);
  }
  {
    const Timer timer(result.cpu_stepping, result.wall_stepping);
    counted([&] { method.start(plan.t_begin, site.initial); });
  }
  if (Outcome outcome = affordable(plan, method.statistics()); !outcome.ok()) return outcome;
  if (site.stepping_begins) site.stepping_begins();
  return advance_over_outputs(site, method, result);
}

}  // namespace

Outcome run_over(RunSite& site, Integrator& method, RunResult& result) {
  try {
    return run_through(site, method, result);
  } catch (const NeedsWhole&) {
    throw;
  } catch (const Refused& refused) {
    return {Status::refused, refused.what()};
  } catch (const std::bad_alloc&) {
    result.threw = true;
    return {Status::failed, out_of_memory};
  } catch (const Error& error) {
    // A file that cannot be written is no fault of the method.
    if (error.code() != ExitCode::numerical) throw;
    result.threw = true;
    return {Status::failed, error.what()};
  } catch (const std::exception& error) {
    result.threw = true;
    return {Status::failed, error.what()};
  }
}

void count_work(const RhsCounters& before, const Rhs& rhs, RunResult& result) {
  const RhsCounters work = difference(difference(rhs.counters(), before), result.pilot_work);
  result.sweeps = work.sweeps;
  result.jacobians = work.jacobians;
  result.potential_solves = work.potential_solves;
}

void take_facts(const Integrator& method, RunResult& result) {
  result.statistics = method.statistics();
  result.t_reached = method.time();
  if (result.choice.empty()) result.choice = method.choice();
  result.settled_at = method.settled_at();
}

}  // namespace superstep
