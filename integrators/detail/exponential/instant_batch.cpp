#include "integrators/detail/exponential/instant_batch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace superstep {
namespace {

constexpr std::size_t most_states = 8;  // held at once

}  // namespace

void InstantBatch::prepare(Rhs& rhs, const Task& task) {
  if (!rhs.traits().linear || !rhs.traits().symmetric)
    throw Refused("the exponential needs a linear scene: constant conductances and no radiation");
  rhs_ = &rhs;
  plan_ = task.plan;
  origin_.resize(rhs.size());
  SpectralRadius radius;
  radius.prepare(rhs, task.spans);
  radius_ = radius.at(task.t_begin, origin_);
  span_ = task.spans.front();
  const std::size_t states = plan_->full_states ? plan_->output_times.size() : 1;
  const auto passes = task.propagations + (states - 1) / most_states;
  const auto capacity = rhs.capacities();
  double total = 0, smallest = std::numeric_limits<double>::infinity();
  for (const double c : capacity) {
    total += c;
    smallest = std::min(smallest, c);
  }
  if (!capacity.empty())
    rms_over_weighted_ = std::sqrt(total / (static_cast<double>(capacity.size()) * smallest));
  // Truncation is bounded in the capacity-weighted norm, and its error may lie in the smallest capacities
  // alone. Roundings are no reason to truncate earlier: that would save a term or two.
  const double allowed = span_ > 0 ? std::min(task.allowed.front() / span_, rtol_) : rtol_;
  share_of_run_ = 1 / static_cast<double>(passes);
  tolerance_ = part_ * allowed / rms_over_weighted_ * share_of_run_;
  magnitude_ = span_ > 0 ? plan_->ranges.back().magnitude() / span_ : 0;
  states_.assign(std::min(states, most_states), StateVector(rhs.size()));
  allocate();
}

void InstantBatch::begin(double t, double /*end*/, std::span<const double> y,
                         std::span<const Instant> instants, bool /*smooth*/) {
  std::copy(y.begin(), y.end(), origin_.begin());
  current_ = origin_;
  instants_ = instants;
  t_ = t_batch_ = t;
  batch_begin_ = batch_size_ = recorded_ = reached_ = 0;
  inflow_before_ = inflow_;
}

Outcome InstantBatch::no_exchange(std::span<Output> outputs) {
  // Linear between breakpoints: the rate at the middle of the time gone by is its mean.
  std::vector<double> rate(rhs_->size());
  for (auto& output : outputs) {
    const double middle = t_batch_ + 0.5 * output.elapsed;
    (*rhs_)(middle, origin_, rate);
    const auto value = [&](std::size_t i) { return origin_[i] + output.elapsed * rate[i]; };
    for (std::size_t i = 0; i < output.state.size(); ++i) output.state[i] = value(i);
    for (std::size_t p = 0; p < plan_->probes.size(); ++p) output.probes[p] = value(plan_->probes[p]);
    output.inflow = plan_->track_inflow ? output.elapsed * rhs_->inflow(middle, origin_) : 0;
  }
  return {};
}

/// As many instants as there is room for states; the last one has a state, from which the next batch goes on.
Outcome InstantBatch::compute_batch(std::size_t first) {
  std::size_t states = 0;
  outputs_.resize(instants_.size() - first);
  batch_begin_ = first;
  batch_size_ = 0;
  for (std::size_t k = 0; k < outputs_.size() && states < states_.size(); ++k) {
    auto& output = outputs_[k];
    const auto& instant = instants_[first + k];
    output.elapsed = instant.t - t_batch_;
    output.state = instant.state ? std::span<double>(states_[states++]) : std::span<double>();
    output.probes.resize(plan_->probes.size());
    if (instant.state) batch_size_ = k + 1;
  }
  ++passes_;
  return propagate(std::span(outputs_).first(batch_size_));
}

Outcome InstantBatch::advance(std::size_t k) {
  if (k >= batch_begin_ + batch_size_) {
    if (current_.data() != origin_.data()) std::copy(current_.begin(), current_.end(), origin_.begin());
    current_ = origin_;
    t_batch_ = t_;
    inflow_before_ = inflow_;
    if (Outcome outcome = compute_batch(k); !outcome.ok()) return outcome;
  }
  const auto& output = outputs_[k - batch_begin_];
  inflow_ = inflow_before_ + output.inflow;
  t_ = instants_[k].t;
  reached_ = k + 1;
  if (!output.state.empty()) current_ = output.state;
  return {};
}

void InstantBatch::record(ProbeHistory& history) {
  for (; recorded_ < reached_; ++recorded_)
    history.append(instants_[recorded_].t, outputs_[recorded_ - batch_begin_].probes);
}

void InstantBatch::add_counts(Statistics& statistics) const {
  statistics.steps += passes_;
  statistics.max_stages = std::max(statistics.max_stages, most_terms_);
  statistics.inflow += inflow_;
  // Truncation, bounded in the capacity-weighted norm, and roundings.
  statistics.error_bound += static_cast<double>(passes_) * tolerance_ * rms_over_weighted_ + rounding_;
}

}  // namespace superstep
