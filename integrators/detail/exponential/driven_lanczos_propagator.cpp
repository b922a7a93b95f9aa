#include "integrators/detail/exponential/driven_lanczos_propagator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/index.hpp"
#include "core/parallel.hpp"
#include "integrators/detail/driver/run_guard.hpp"

namespace superstep {
namespace {

double sum_of(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += std::abs(value);
  return sum;
}

}  // namespace

void DrivenLanczosPropagator::allocate() {
  auto shapes = rhs().input_shapes();
  const auto storage = LanczosSpace::storage_for(part_allowed() / static_cast<double>(1 + shapes.size()));
  const double vector = static_cast<double>(std::max<std::size_t>(1, rhs().reduction().total()) *
                                            static_cast<std::size_t>(storage));
  constexpr double most_ever = 40'000;
  most_vectors_ = static_cast<std::size_t>(std::min(memory_ / vector, most_ever));
  inputs_.clear();
  inputs_.emplace_back(rhs(), storage, recent_);
  const auto capacity = rhs().capacities();
  for (auto& shape : shapes) {
    Input& input = inputs_.emplace_back(rhs(), storage, recent_);
    ExactSum inflow;
    for (const auto& rate : shape.rates) inflow.add(capacity[at(rate.entry)] * rate.rate);
    input.inflow_rate = rhs().reduction().sum(inflow);
    input.shape = std::move(shape);
  }
}

/// A line that was short beside the time gone by since is two steps, at Gauss's points: what that leaves out
/// is (duration / time since)^4 / 3000 of what it did. As two kinks it is the difference of two large
/// numbers, whose rounding may count.
bool DrivenLanczosPropagator::acts_as_steps(const Input& input, double slope, double since_begin,
                                            double since_end) const {
  constexpr double is_short = 1e-3, counts = 1e-6;
  if (!(since_end > 0 && since_begin - since_end < is_short * since_end)) return false;
  const double rounding = response_error * std::abs(slope) * since_begin * since_begin;
  return rounding * input.space.length() * rms_over_norm() > counts * allowed();
}

/// The input seen from time t: steps and kinks of its table since the start, and the start itself, from where
/// on it is a line.
void DrivenLanczosPropagator::look_back(Input& input, double t) const {
  auto& changes = input.changes;
  changes.clear();
  const double begin = now();
  if (!input.shape.table) return changes.push_back({.since = t - begin, .jump = 1, .kink = 0});
  const auto& time = input.shape.table->time;
  const auto& value = input.shape.table->value;
  const auto slope_after = [&](std::size_t k) {  // of the piece that begins at knot k
    const bool inside = k + 1 < time.size() && time[k + 1] > time[k];
    return inside ? (value[k + 1] - value[k]) / (time[k + 1] - time[k]) : 0.0;
  };
  const auto after = [&](double instant) {
    return static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), instant) - time.begin());
  };
  double going_on = 0;  // slope of the line that is left by the changes so far
  const auto add_piece = [&](double from, double to, double slope, double jump) {
    const bool steep = acts_as_steps(input, slope, t - from, t - to);
    changes.push_back({.since = t - from, .jump = jump, .kink = (steep ? 0 : slope) - going_on});
    going_on = steep ? 0 : slope;
    if (!steep) return;
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from), apart = half / std::numbers::sqrt3;
    for (const double at : {middle - apart, middle + apart})
      changes.push_back({.since = t - at, .jump = half * slope, .kink = 0});
  };
  std::size_t k = after(begin);
  double from = begin, slope = k > 0 ? slope_after(k - 1) : 0, jump = 0;
  while (k < time.size() && time[k] < t) {
    add_piece(from, time[k], slope, jump);
    std::size_t last = k;  // of the knots at this instant
    while (last + 1 < time.size() && time[last + 1] == time[k]) ++last;
    from = time[k];
    jump = value[last] - value[k];
    slope = slope_after(last);
    k = last + 1;
  }
  add_piece(from, t, slope, jump);
  std::erase_if(changes, [](const auto& change) { return change.jump == 0 && change.kink == 0; });
  std::reverse(changes.begin(), changes.end());
}

LanczosSpace::Input DrivenLanczosPropagator::size_of(const Input& input) const {
  if (!input.shape.table) return {};
  const auto& table = *input.shape.table;
  const double end = now() + stretch(), start = table.at(now());
  double sum = 0, last = start;
  const auto go_to = [&](double value) { sum += std::abs(value - std::exchange(last, value)); };
  for (std::size_t k = 0; k < table.time.size(); ++k)
    if (table.time[k] > now() && table.time[k] < end) go_to(table.value[k]);
  go_to(table.before(end));
  const auto [low, high] = table.range(now(), end);
  return {.largest = std::max(high - start, start - low), .variation = sum};
}

/// Until the space holds what its input does by the end of the run.
Outcome DrivenLanczosPropagator::grow(Input& input) {
  auto& space = input.space;
  space.open(stretch(), plan().track_inflow, [&](std::span<double> first) {
    if (!input.shape.table) return rhs()(now(), origin(), first);
    std::fill(first.begin(), first.end(), 0.0);
    for (const auto& rate : input.shape.rates) first[at(rate.entry)] += rate.rate;
  });
  input.reported = {};
  input.size = size_of(input);
  const double share = allowed() / static_cast<double>(inputs_.size());
  const auto growth =
      space.grow(stretch(), share, rms_over_norm(), input.size, most_vectors_ - vectors_, plan().stop);
  vectors_ += space.dimension();
  count_terms(space.dimension());
  if (growth == LanczosSpace::Growth::stopped) return interrupted_at(now());
  if (growth == LanczosSpace::Growth::covers) return {};
  return {Status::failed, fmt::format("{} Lanczos vectors do not hold what the inputs do; give them more "
                                      "memory, or use basis=chebyshev",
                                      most_vectors_)};
}

void DrivenLanczosPropagator::add_responses(Input& input, std::span<Output> outputs) {
  const auto& space = input.space;
  const std::size_t m = space.dimension();
  std::vector<std::vector<double>> factors(outputs.size());
  std::vector<std::span<double>> states;
  SmallSolution largest;
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    Output& output = outputs[k];
    states.push_back(output.state);
    const double t = now() + output.elapsed;
    if (const auto* table = input.shape.table)
      output.inflow += input.inflow_rate * (table->integral(now(), t) - output.elapsed * table->at(now()));
    look_back(input, t);
    if (m == 0 || input.changes.empty()) continue;
    auto response = tridiagonal_response(space.alpha(), space.beta().first(m - 1), input.changes);
    for (std::size_t j = 0; j < space.inflow().size(); ++j)
      output.inflow += space.length() * response.integral[j] * space.inflow()[j];
    for (double& factor : response.value) factor *= space.length();
    for (std::size_t p = 0; p < plan().probes.size(); ++p)
      output.probes[p] += space.entry(plan().probes[p], response.value);
    largest.integral = std::max(largest.integral, sum_of(response.integral));
    largest.factors = std::max(largest.factors, sum_of(response.value));
    double changed = 0;
    for (const auto& one : input.changes)
      changed += one.since * (std::abs(one.jump) + 0.5 * one.since * std::abs(one.kink));
    largest.changed = std::max(largest.changed, changed);
    factors[k] = std::move(response.value);
  }
  report(input, outputs.back().elapsed, largest);
  space.add_to(states, std::move(factors));
}

/// Adds what the error bound has grown by. A space without vectors has one, too: all that its input does.
void DrivenLanczosPropagator::report(Input& input, double elapsed, const SmallSolution& largest) {
  constexpr double roundings = 4 * std::numeric_limits<double>::epsilon();
  const auto& space = input.space;
  const double rounding =
      space.length() * (roundings * rhs().spectral_bound(now(), origin()) * largest.integral +
                        response_error * largest.changed) +
      largest.factors * space.rounding();
  add_growth({space.bound_at(elapsed, input.size.largest) * rms_over_norm(), rounding * rms_over_norm()},
             input.reported);
}

Outcome DrivenLanczosPropagator::propagate(std::span<Output> outputs) {
  if (!grown_) {
    vectors_ = 0;
    for (auto& input : inputs_)
      if (Outcome outcome = grow(input); !outcome.ok()) return outcome;
    constant_inflow_ = plan().track_inflow ? rhs().inflow(now(), origin()) : 0;
    add_bound(0, std::numeric_limits<double>::epsilon() * magnitude());  // of what is stored
    grown_ = true;
  }
  for (auto& output : outputs) {
    std::copy_n(origin().begin(), output.state.size(), output.state.begin());
    for (std::size_t p = 0; p < plan().probes.size(); ++p) output.probes[p] = origin()[plan().probes[p]];
    output.inflow = constant_inflow_ * output.elapsed;
  }
  for (auto& input : inputs_) add_responses(input, outputs);
  return {};
}

}  // namespace superstep
