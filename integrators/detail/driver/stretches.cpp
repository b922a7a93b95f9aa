/// The loop's part for propagators: instants of smooth stretches.

#include "integrators/detail/driver/driver.hpp"

namespace superstep {
namespace {

constexpr std::size_t recorded_per_output = 64;  // instants between two output times

}  // namespace

/// Output times of the stretch that begins now, its end, and what a history wants between them.
void Driver::list_instants() {
  instants_.clear();
  next_instant_ = 0;
  const double end = piece_end();
  double before = t_;
  const auto add = [&](double t, bool state) {
    const bool between = recorder_.history() && !propagator_->stops_on_the_way();
    for (std::size_t k = 1; between && k < recorded_per_output; ++k)
      instants_.push_back({before + (t - before) * static_cast<double>(k) / recorded_per_output, false});
    instants_.push_back({t, state});
    before = t;
  };
  for (const double t : plan_.output_times)
    if (t > t_ && t <= end) add(t, plan_.full_states || t == end);
  if (before < end && next_breakpoint_ < rhs_->facts().breakpoints.size()) add(end, true);
}

Outcome Driver::propagate_to(double target) {
  while (t_ < target) {
    const auto& instant = instants_[next_instant_];
    if (Outcome outcome = propagator_->advance(next_instant_); !outcome.ok()) return outcome;
    t_ = propagator_->time();
    const bool reached = t_ == instant.t;
    if (reached) ++next_instant_;
    publish();
    if (recorder_.history() && !settled_at_) propagator_->record(*recorder_.history());
    if (Outcome outcome = may_go_on(); !outcome.ok()) return outcome;
    const bool visible = (reached && instant.state) || propagator_->stops_on_the_way();
    if (!visible) continue;
    const auto y = propagator_->state();
    std::copy(y.begin(), y.end(), state_.begin());
    note_extremes();
    if (settled_at_ && recorder_.history()) {
      complete_state();
      recorder_.record(t_, full_);
    }
    if (!reached)
      if (Outcome outcome = look_at(state_); !outcome.ok()) return outcome;
    const Rhs* before = rhs_;
    settle_if_steady();
    if (rhs_ != before) return {};
  }
  return {};
}

}  // namespace superstep
