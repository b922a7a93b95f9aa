#include "bench/measure/shared/shared_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "bench/host/interrupt.hpp"
#include "bench/host/terminal.hpp"
#include "bench/measure/range_watch.hpp"
#include "bench/measure/run_over.hpp"
#include "bench/measure/shared/worker.hpp"
#include "core/error.hpp"
#include "core/stopwatch.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

bool running = false;

/// What everybody has to know of a run.
struct RunOrder {
  std::string spec;
  Plan plan;  ///< for the whole scene; its probes are entries of the whole state
  bool records = false, observed = false;
  std::string frames = {};  ///< folder of fields to draw; empty = none are wished
};

void pack(const RunOrder& order, Packer& out) {
  const Plan& plan = order.plan;
  out.put(order.spec);
  out.put(order.records);
  out.put(order.observed);
  out.put(order.frames);
  out.put(plan.t_begin);
  out.put(plan.output_times);
  out.put(plan.ranges);
  out.put(plan.spans);
  out.put(plan.probes);
  out.put(plan.full_states);
  out.put(plan.track_inflow);
  out.put(plan.settle_tolerance);
  out.put(plan.most_sweeps);
}

RunOrder unpack_order(Unpacker& in) {
  RunOrder order;
  Plan& plan = order.plan;
  in.take(order.spec);
  in.take(order.records);
  in.take(order.observed);
  in.take(order.frames);
  in.take(plan.t_begin);
  in.take(plan.output_times);
  in.take(plan.ranges);
  in.take(plan.spans);
  in.take(plan.probes);
  in.take(plan.full_states);
  in.take(plan.track_inflow);
  in.take(plan.settle_tolerance);
  in.take(plan.most_sweeps);
  return order;
}

/// Probes that are here: their numbers among all, and entries of the own state.
struct OwnProbes {
  std::vector<std::size_t> number, entry;
};

OwnProbes own_probes(const Rhs& part, const std::vector<std::size_t>& probes) {
  OwnProbes own;
  for (std::size_t p = 0; p < probes.size(); ++p)
    if (const auto entry = own_entry(part, probes[p]); entry >= 0) {
      own.number.push_back(p);
      own.entry.push_back(static_cast<std::size_t>(entry));
    }
  return own;
}

/// Step ends are the same everywhere: the root puts the values of all probes beside each other.
ProbeHistory gather_history(std::size_t probes, const OwnProbes& own, const ProbeHistory& history) {
  const auto data = history.data();
  if (!world().is_root()) {
    Packer out;
    out.put(own.number);
    out.put(data.coefficient);
    world().send(0, out.bytes());
    return {};
  }
  std::size_t rows = 0;  // of coefficients
  for (const int order : data.order) rows += static_cast<std::size_t>(order) + 1;
  ProbeHistory::Data all{data.time, data.order, std::vector<double>(rows * probes)};
  const auto put = [&](const std::vector<std::size_t>& number, const std::vector<double>& coefficient) {
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t k = 0; k < number.size(); ++k)
        all.coefficient[row * probes + number[k]] = coefficient[row * number.size() + k];
  };
  put(own.number, data.coefficient);
  for (int from = 1; from < world().size(); ++from) {
    const auto bytes = world().receive(from);
    Unpacker in(bytes);
    const auto number = in.take<std::vector<std::size_t>>();
    put(number, in.take<std::vector<double>>());
  }
  return ProbeHistory::from(probes, all);
}

double sum_over_all(double own) {
  ExactSum sum;
  sum.add(own);
  return world().sum(sum);
}

/// Costs of all processes together.
void add_up_costs(const Traffic& before, double entries, RunResult& result) {
  const Traffic own = world().traffic();
  result.processes = world().size();
  result.distributed = "exact";
  result.reductions = own.reductions - before.reductions;
  result.halo_messages = world().sum(own.halo_messages - before.halo_messages);
  result.halo_bytes = world().sum(own.halo_bytes - before.halo_bytes);
  for (double* cpu : {&result.cpu_pilot, &result.cpu_prepare, &result.cpu_stepping})
    *cpu = sum_over_all(*cpu);
  for (double* wall : {&result.wall_prepare, &result.wall_stepping}) *wall = world().max(*wall);
  result.peak_memory_mb = sum_over_all(peak_memory_megabytes());
  const double mean = sum_over_all(entries) / world().size();
  result.imbalance = world().max(entries) / std::max(1.0, mean);
}

/// An exception is either everybody's, or it ends all: the others would wait for ever. That memory is short
/// is rarely everybody's.
void settle_exception(const Outcome& outcome) {
  const double patience = outcome.reason == out_of_memory ? 1 : 30;  // s
  if (world().all_arrive(patience)) return;
  note("error: ", fmt::format("process {} of {}: {}", world().rank() + 1, world().size(), outcome.reason));
  world().abort(static_cast<int>(ExitCode::numerical));
}

/// Looks at the states of a scene that nobody has as a whole.
///   here  what is here of it;  range  of its values
auto observer_of_part(const Scene& here, ScenePart& part, const RunOrder& order, const RunRequest& request,
                      RangeWatch& range) {
  return [&](std::size_t output, double t, std::span<const double> state) {
    range.observe(t, state);
    if (!order.frames.empty()) request.write_frame(here, order.frames, output + 1, t, state);
    if (request.observe) return request.observe(output, t, state);  // the root keeps it as it likes
    if (output + 1 == order.plan.output_times.size()) part.final_state.assign(state.begin(), state.end());
  };
}

///   here  what is here of a scene that nobody has as a whole
Outcome take_part_in(ScenePart& part, const Scene* here, const RunOrder& order, const RunRequest& request,
                     const std::function<void()>& stepping_begins, RunResult& result) {
  const auto method = make_integrator(order.spec);
  const Traffic traffic = world().traffic();
  Plan plan = order.plan;
  plan.stop = &world().agreed();
  const OwnProbes probes = own_probes(*part.rhs, order.plan.probes);
  plan.probes = probes.entry;
  if (order.records) {
    std::vector<double> initial;
    for (const auto entry : probes.entry) initial.push_back(part.initial[entry]);
    result.history = ProbeHistory(probes.entry.size());
    result.history.append(plan.t_begin, initial);
    plan.history = &result.history;
  }
  std::function<void(std::size_t, double, std::span<const double>)> observe;
  std::optional<RangeWatch> range;
  if (here)
    observe = observer_of_part(*here, part, order, request, range.emplace(*here));
  else if (order.observed)
    observe = [&](std::size_t output, double t, std::span<const double> state) {
      const auto whole = whole_state(*part.rhs, state);
      if (request.observe) request.observe(output, t, whole);
    };
  RunSite site{.rhs = *part.rhs,
               .initial = part.initial,
               .plan = std::move(plan),
               .observe = observe,
               .progress = request.progress,
               .stepping_begins = stepping_begins};
  if (here && !order.frames.empty())
    request.write_frame(*here, order.frames, 0, order.plan.t_begin, part.initial);
  const RhsCounters before = part.rhs->counters();
  Outcome outcome = run_over(site, *method, result);
  if (result.threw) settle_exception(outcome);
  count_work(before, *part.rhs, result);
  take_facts(*method, result);
  add_up_costs(traffic, part.entries, result);
  if (range)
    for (const double own : range->overshoot()) result.overshoot.push_back(world().max(own));
  if (order.records) result.history = gather_history(order.plan.probes.size(), probes, result.history);
  return outcome;
}

}  // namespace

Outcome run_shared(const Scene& scene, const std::string& spec, const Plan& plan, const RunRequest& request,
                   const std::function<void()>& stepping_begins, RunResult& result) {
  static ScenePart part;
  if (part.scene != scene.rhs->identity()) {
    part = {};  // the old one first: there may not be room for both
    part = share_out(scene);
  }
  RunOrder order{.spec = spec, .plan = plan};
  order.records = request.probes && !request.probes->entries().empty();
  order.observed = static_cast<bool>(request.observe);
  order.frames = request.frames;
  if (order.records) order.plan.probes = request.probes->entries();
  Packer out;
  out.put(Order::run);
  pack(order, out);
  for (int to = 1; to < world().size(); ++to) world().send(to, out.bytes());
  world().watch(plan.stop);
  running = true;
  try {
    order.plan.reached = plan.reached;
    Outcome outcome =
        take_part_in(part, part.in_parts ? &scene : nullptr, order, request, stepping_begins, result);
    running = false;
    world().watch(nullptr);
    return outcome;
  } catch (const NeedsWhole&) {  // everybody's
    running = false;
    world().watch(nullptr);
    throw;
  } catch (const EverybodysError&) {
    running = false;
    world().watch(nullptr);
    throw;
  }
}

void join_run(ScenePart& part, Unpacker& in, const WriteFrame& write_frame) {
  const RunOrder order = unpack_order(in);
  world().watch(&stop_flag());
  RunResult result;
  try {
    RunRequest request;
    request.write_frame = write_frame;
    (void)take_part_in(part, part.scene_here.get(), order, request, {}, result);
  } catch (const NeedsWhole&) {       // the root does it alone
  } catch (const EverybodysError&) {  // the root says it
  }
  world().watch(nullptr);
}

bool in_shared_run() noexcept {
  return running;
}

}  // namespace superstep
