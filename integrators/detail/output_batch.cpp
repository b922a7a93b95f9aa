#include "integrators/detail/output_batch.hpp"

#include <algorithm>

namespace superstep {
namespace {

constexpr std::size_t largest_batch = 8;        // full states held at once
constexpr std::size_t history_per_output = 64;  // recorded instants between two output times

}  // namespace

void BatchPropagator::prepare(Rhs& rhs, const Plan& plan) {
  if (!rhs.traits().linear || !rhs.traits().symmetric || !rhs.traits().autonomous)
    throw Refused(
        "the exponential needs a linear scene with constant conductances, sources and fixed values");
  rhs_ = &rhs;
  plan_ = plan;
  guard_.prepare(rhs, plan);
  SpectralRadius spectral_radius;
  first_state_.resize(rhs.size());
  radius_ = spectral_radius.at(rhs, plan.t_begin, first_state_);
  // Probe-only outputs cost nothing, and without states a second batch could not begin: all in one.
  const std::size_t most = plan.full_states ? largest_batch : plan.output_times.size();
  const std::size_t full = std::min(most, plan.output_times.size());
  const std::size_t instants = plan.history ? history_per_output : 1;
  outputs_.resize(full * instants);
  for (std::size_t k = 0; k < outputs_.size(); ++k) {
    outputs_[k].probes.resize(plan.probes.size());
    outputs_[k].full = (k + 1) % instants == 0 && plan.full_states;
    if (outputs_[k].full) outputs_[k].state.resize(rhs.size());
  }
  allocate(outputs_.size());
}

void BatchPropagator::start_at(double t, std::span<const double> y, std::size_t next_output) {
  rhs_->restart(t);
  std::copy(y.begin(), y.end(), first_state_.begin());
  origin_ = current_ = &first_state_;
  t_ = t_batch_ = t;
  next_output_ = batch_begin_ = next_output;
  batch_size_ = 0;
  inflow_before_ = 0;
  statistics_ = {};
}

Outcome BatchPropagator::no_exchange(std::span<Output> outputs) {
  std::vector<double> rate(rhs_->size());
  (*rhs_)(t_batch_, *origin_, rate);
  const double inflow = rhs_->inflow(t_batch_, *origin_);
  for (auto& output : outputs) {
    for (std::size_t i = 0; i < output.state.size(); ++i)
      output.state[i] = (*origin_)[i] + output.elapsed * rate[i];
    for (std::size_t p = 0; p < plan_.probes.size(); ++p)
      output.probes[p] = (*origin_)[plan_.probes[p]] + output.elapsed * rate[plan_.probes[p]];
    output.inflow = plan_.track_inflow ? output.elapsed * inflow : 0;
  }
  return {};
}

Outcome BatchPropagator::compute_batch() {
  const std::size_t instants = plan_.history ? history_per_output : 1;
  const std::size_t most = outputs_.size() / instants;
  batch_begin_ = next_output_;
  batch_size_ = std::min(most, plan_.output_times.size() - next_output_);
  double before = t_;
  for (std::size_t k = 0; k < batch_size_; ++k) {
    const double t_out = plan_.output_times[batch_begin_ + k];
    for (std::size_t i = 1; i <= instants; ++i)
      outputs_[k * instants + i - 1].elapsed =
          before + (t_out - before) * static_cast<double>(i) / static_cast<double>(instants) - t_batch_;
    before = t_out;
  }
  ++statistics_.steps;
  return propagate(std::span(outputs_).first(batch_size_ * instants));
}

Outcome BatchPropagator::advance(double t_out) {
  if (guard_.stop_requested(t_)) return interrupted_at(t_);
  const std::size_t instants = plan_.history ? history_per_output : 1;
  if (next_output_ == batch_begin_ + batch_size_) {
    if (current_ != &first_state_ && !current_->empty())
      first_state_ = *current_;  // same size: no allocation
    origin_ = current_ = &first_state_;
    t_batch_ = t_;
    inflow_before_ = statistics_.inflow;
    if (Outcome outcome = compute_batch(); !outcome.ok()) return outcome;
  }
  const std::size_t first = (next_output_ - batch_begin_) * instants;
  for (std::size_t k = first; k < first + instants && plan_.history; ++k)
    plan_.history->append(k + 1 == first + instants ? t_out : t_batch_ + outputs_[k].elapsed,
                          outputs_[k].probes);
  const auto& output = outputs_[first + instants - 1];
  statistics_.inflow = inflow_before_ + output.inflow;
  t_ = t_out;
  ++next_output_;
  if (!plan_.full_states) return {};
  current_ = &output.state;
  return guard_.check(t_, *current_);
}

}  // namespace superstep
