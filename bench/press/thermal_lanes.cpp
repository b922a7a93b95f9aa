#include "bench/press/thermal_lanes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "bench/harness/verification.hpp"
#include "core/stopwatch.hpp"
#include "integrators/method_spec.hpp"
#include "integrators/press/motion.hpp"

namespace superstep {
namespace {

using dynamics::Motion;
using dynamics::MovingNetwork;
using dynamics::ThermalBridge;

/// One method with temperatures of its own.
struct Lane {
  Lane(const std::string& lane_spec, std::vector<double> initial, int repetitions)
      : spec(lane_spec), temperature(std::move(initial)) {
    for (int k = 0; k < repetitions; ++k) bridges.emplace_back(spec);
  }

  std::string spec;
  std::vector<double> temperature;     // [particles] K
  std::vector<ThermalBridge> bridges;  // one for each repetition, for its costs
  Outcome outcome;
  FieldErrors errors;
};

/// One repetition of one contact update; the first one counts, the others are only timed.
void advance(Lane& lane, std::size_t repetition, const MovingNetwork& network, double h,
             const std::vector<double>& begin, double most_seconds, const std::atomic<bool>* stop) {
  if (!lane.outcome.ok()) return;
  const ThermalBridge& bridge = lane.bridges[repetition];
  if (most_seconds > 0 && bridge.cpu_stepping() + bridge.cpu_building() > most_seconds) {
    lane.outcome = {Status::timeout, fmt::format("not done after {:g} s; allow it more with --time-limit, or "
                                                 "take another method",
                                                 most_seconds)};
    return;
  }
  std::vector<double> temperature = begin;
  Outcome outcome = lane.bridges[repetition].advance(network, h, temperature, stop);
  if (repetition == 0) lane.temperature = std::move(temperature);
  if (!outcome.ok()) lane.outcome = std::move(outcome);
}

void advance_all(std::vector<Lane>& lanes, std::size_t repetitions, const MovingNetwork& network, double h,
                 double most_seconds, const std::atomic<bool>* stop) {
  std::vector<std::vector<double>> begin;
  for (const auto& lane : lanes) begin.push_back(lane.temperature);
  for (std::size_t k = 0; k < repetitions; ++k)
    for (const std::size_t lane : round_order(lanes.size(), k))
      advance(lanes[lane], k, network, h, begin[lane], most_seconds, stop);
}

void raise(Number& worst, double value) {
  worst = std::max(worst.value_or(0.0), value);
}

void measure(Lane& lane, const std::vector<double>& exact) {
  if (!lane.outcome.ok()) return;
  double sum = 0, largest = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const double difference = std::abs(lane.temperature[i] - exact[i]);
    sum += difference * difference;
    largest = std::max(largest, difference);
  }
  const double rms = std::sqrt(sum / static_cast<double>(exact.size()));
  raise(lane.errors.rms, rms);
  raise(lane.errors.max, largest);
}

/// How far the reference may be off, over the span; infinite where it keeps no tolerance.
double bar_of(const std::string& reference) {
  const double rtol = MethodSpec(reference).rtol();
  // No solution is better known than twice the tolerance that it was computed with.
  return rtol > 0 ? 2 * rtol : std::numeric_limits<double>::infinity();
}

/// `span` [K]: range of all temperatures in the run; `bar` [-]: of the reference.
void judge(Lane& lane, double span, double bar) {
  FieldErrors& errors = lane.errors;
  if (!lane.outcome.ok() || !errors.rms || !(span > 0)) return;
  errors.span = span;
  errors.relative_rms = *errors.rms / span;
  if (const double rtol = MethodSpec(lane.spec).rtol(); rtol > 0)
    errors.delivered = delivered_error(*errors.relative_rms, bar, rtol);
  judge(errors, "temperature", "K", lane.outcome);
}

Timing timing_of(const Lane& lane, bool with_building) {
  std::vector<double> seconds;
  for (const auto& bridge : lane.bridges)
    seconds.push_back(bridge.cpu_stepping() + (with_building ? bridge.cpu_building() : 0));
  return summarize(seconds);
}

BenchRow row_of(const BenchCase& one, const Lane& lane, const HarnessOptions& options) {
  BenchRow row = begin_row(one, lane.spec, options.threads);
  row.status = status_name(lane.outcome.status);
  row.reason = lane.outcome.reason;
  row.repetitions = options.repetitions;
  row.errors = lane.errors;
  if (one.reference) row.reference = one.reference->spec;
  if (!lane.outcome.ok() && lane.outcome.status != Status::inaccurate) return row;
  row.cpu_stepping = timing_of(lane, false);
  row.cpu_total = timing_of(lane, true);
  const ThermalBridge& bridge = lane.bridges.front();
  row.steps = bridge.steps();
  row.rejected = bridge.rejected();
  row.rhs = bridge.sweeps();
  row.jacobians = bridge.jacobians();
  row.factorizations = bridge.factorizations();
  row.solves = bridge.solves();
  row.max_stages = static_cast<std::uint64_t>(bridge.max_stages());
  return row;
}

}  // namespace

BenchCase bench_thermal_lanes(const Press& one, double cpu_setup, const HarnessOptions& options,
                              Progress& progress) {
  const std::string reference = options.reference.empty() ? reference_of_lanes : options.reference;
  const bool referenced = reference != "none";
  const auto repetitions = static_cast<std::size_t>(options.repetitions);
  std::vector<Lane> lanes;
  for (const auto& spec : contenders(one.bench, options.integrators))
    lanes.emplace_back(spec, one.state.temperature, options.repetitions);
  std::vector<Lane> exact;
  if (referenced) exact.emplace_back(reference, one.state.temperature, 1);

  Motion motion(one.model, one.particles, one.stepping);
  motion.stop = options.stop;
  std::size_t updates = 0, contacts = 0;
  double low = one.state.temperature.front(), high = low;
  motion.observe_step = [&](const MovingNetwork& network, double h) {
    ++updates;
    contacts = std::max(contacts, network.contacts().touching());
    advance_all(lanes, repetitions, network, h, options.limits.seconds, options.stop);
    if (referenced)
      advance_all(exact, 1, network, h, limits_of_reference(options.limits).seconds, options.stop);
    progress.reached(motion.state().time);
  };
  progress.begin(one.name, one.t_end);
  motion.start(one.state);
  Outcome outcome;
  for (const double t : one.output_times) {
    outcome = motion.advance(t);
    if (!outcome.ok()) break;
    if (!referenced || !exact.front().outcome.ok()) continue;
    const auto& truth = exact.front().temperature;
    const auto [coldest, hottest] = std::minmax_element(truth.begin(), truth.end());
    low = std::min(low, *coldest);
    high = std::max(high, *hottest);
    for (auto& lane : lanes) measure(lane, truth);
  }
  progress.end();

  BenchCase result = begin_case(one);
  result.cpu_setup = cpu_setup;
  result.warnings = one.warnings;
  result.nodes = result.unknowns = one.particles.size();
  result.contacts = contacts;
  result.unit.push_back('K');  // assigning a literal makes g++ 12 warn about overlapping memory
  if (referenced) {
    result.reference = ReferenceFacts{reference, false, exact.front().bridges.front().cpu_stepping()};
    if (!exact.front().outcome.ok())
      result.warnings.push_back("the reference failed: " + exact.front().outcome.reason);
  }
  for (auto& lane : lanes) {
    if (!outcome.ok() && lane.outcome.ok()) lane.outcome = outcome;
    judge(lane, high - low, referenced ? bar_of(reference) : 0);
    result.rows.push_back(row_of(result, lane, options));
  }
  compare_with_baseline(result);
  warn_of_untold_tolerances(result);
  result.warnings.push_back(
      fmt::format("every method starts anew after each of the {} contact updates; its preparation is part of "
                  "its stepping",
                  updates));
  return result;
}

}  // namespace superstep
