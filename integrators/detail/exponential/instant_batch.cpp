#include "integrators/detail/exponential/instant_batch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace superstep {
namespace {

constexpr std::size_t most_states = 8;  // held at once

}  // namespace

void InstantBatch::prepare(Rhs& rhs, const Task& task) {
  if (!rhs.traits().linear || !rhs.traits().symmetric || rhs.fields().size() > 1)
    throw Refused(
        "the exponential of one field needs a linear scene: constant conductances and no radiation");
  rhs_ = &rhs;
  plan_ = task.plan;
  origin_.resize(rhs.size());
  span_ = task.spans.front();
  const std::size_t states = plan_->full_states ? plan_->output_times.size() : 1;
  const std::size_t stretches = takes_breakpoints() ? 1 : task.propagations;
  const std::size_t passes = stretches + (keeps_origin() ? 0 : (states - 1) / most_states);
  const auto capacity = rhs.capacities();
  const auto& reduction = rhs.reduction();
  const double total = reduction.sum([&](std::size_t i) { return capacity[i]; });
  double smallest = std::numeric_limits<double>::infinity();
  for (const double c : capacity) smallest = std::min(smallest, c);
  smallest = reduction.smallest(smallest);
  const auto rows = static_cast<double>(reduction.total());
  rms_over_weighted_ = rows > 0 ? std::sqrt(total / (rows * smallest)) : 1;
  norm_of_one_ = rows > 0 ? std::sqrt(total) : 1;
  const double largest = plan_->ranges.back().magnitude();
  constexpr double roundings = 100;  // of a value, where there is no span to be right within
  allowed_ = span_ > 0 ? task.allowed.front() : roundings * std::numeric_limits<double>::epsilon() * largest;
  share_of_run_ = 1 / static_cast<double>(passes);
  allowed_ *= part_ * share_of_run_;
  part_allowed_ = std::min(span_ > 0 ? task.allowed.front() / span_ : rtol_, rtol_) * part_ * share_of_run_;
  magnitude_ = span_ > 0 ? largest / span_ : 0;
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
  start_over();
}

void InstantBatch::add_growth(const Bounds& now, Bounds& before) noexcept {
  if (!(now.truncation + now.rounding < span_)) return give_up_bound();
  const auto growth = [&](double Bounds::*part) {
    const double more = std::max(now.*part - before.*part, 0.0);
    before.*part += more;
    return more / span_;
  };
  const double truncation = growth(&Bounds::truncation);
  add_bound(truncation, growth(&Bounds::rounding));
}

double InstantBatch::dot(std::span<const double> a, std::span<const double> b) const {
  return rhs_->reduction().sum([c = rhs_->capacities().data(), x = a.data(), y = b.data()](std::size_t i) {
    return c[i] * x[i] * y[i];
  });
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
  ++batches_;
  return propagate(std::span(outputs_).first(batch_size_));
}

/// The next batch goes on from where the last one ended.
void InstantBatch::move_origin() {
  if (current_.data() != origin_.data()) std::copy(current_.begin(), current_.end(), origin_.begin());
  current_ = origin_;
  t_batch_ = t_;
  inflow_before_ = inflow_;
  start_over();
}

Outcome InstantBatch::advance(std::size_t k) {
  if (k >= batch_begin_ + batch_size_) {
    if (batch_size_ > 0 && !keeps_origin()) move_origin();
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
  statistics.steps += batches_;
  statistics.max_stages = std::max(statistics.max_stages, most_terms_);
  statistics.inflow += inflow_;
  if (!bounded_) return;
  statistics.error_bound += bound_;
  statistics.rounding_bound += rounding_;
}

}  // namespace superstep
