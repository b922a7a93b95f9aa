/// The loop's part for one-step methods.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/parallel.hpp"
#include "integrators/detail/driver/driver.hpp"
#include "integrators/detail/error_norm.hpp"

namespace superstep {
namespace {

constexpr double smallest_shrink = 0.1;
constexpr int most_lawless = 1000;  // of one run: its solution leaves the law for good
constexpr double most_own_steps = 1e12;

}  // namespace

Outcome Driver::step_to(double target) {
  using Pace = OneStepMethod::Pace;
  const bool own = stepper_->pace() == Pace::multiples || stepper_->pace() == Pace::equal;
  return own ? take_own_steps(target) : take_controlled_steps(target);
}

Outcome Driver::take_own_steps(double target) {
  const bool varies = stepper_->stability_varies();
  while (t_ < target) {
    if (lattice_.target != target || varies) {
      const double step = std::min(cap_, stepper_->own_step(t_, state_));
      const std::uint64_t count = steps_to_cover(target - t_, step);
      if (static_cast<double>(count) > most_own_steps)
        return too_short(
            fmt::format("steps of {:.3g} s, the stable ones at t = {:.6g} s, would be {:.2g} "
                        "to the end; take an implicit method, or auto",
                        step, t_, static_cast<double>(count)));
      const bool equal = stepper_->pace() == OneStepMethod::Pace::equal;
      lattice_ = {t_, target, equal ? (target - t_) / static_cast<double>(count) : step, count, 0};
    }
    const std::uint64_t longest = varies || recorder_.history() ? 1 : stepper_->longest_chain_of_steps();
    const auto chain = std::min<std::uint64_t>(longest, lattice_.count - lattice_.done);
    ends_.clear();
    for (std::uint64_t k = lattice_.done + 1; k <= lattice_.done + chain; ++k)
      ends_.push_back(k == lattice_.count ? target : lattice_.from + static_cast<double>(k) * lattice_.step);
    const Step step{t_, ends_};
    const Look look = try_step(step);
    if (!look.trial.solved || !look.stable || !look.lawful) {
      ++counted_.rejected;
      const double h = step.h();
      if (!varies || t_ + smallest_shrink * h <= t_ || lawless_ > most_lawless) return cannot_shrink(h, look);
      cap_ = std::clamp(look.limit, smallest_shrink * h, 0.5 * h);
    } else {
      lattice_.done += chain;
      if (varies) cap_ = std::max(2 * step.h(), cap_ < 1e300 ? cap_ : 0);
      accept(step);
      if (Outcome outcome = after_step(); !outcome.ok()) return outcome;
      if (lattice_.target != target) return {};  // a settled field has left another scene behind
      continue;
    }
    if (Outcome outcome = may_go_on(); !outcome.ok()) return outcome;
  }
  return {};
}

Driver::Look Driver::try_step(const Step& step) {
  Look look;
  look.trial = stepper_->attempt(step, state_, next_);
  if (!look.trial.solved) return look;
  const double t_end = step.ends.back();
  if (auto violation = rhs_->law_violation(next_, law_slack())) {
    look.lawful = false;
    ++lawless_;
    lawless_why_ = std::move(*violation);
    lawless_step_ = counted_.steps;
  }
  if (stepper_->stability_varies()) {
    look.limit = stepper_->stable_step(t_end, next_);
    constexpr double rounding = 1e-9;
    look.stable = step.h() <= look.limit * (1 + rounding);  // false for NaN as well
  }
  return look;
}

Outcome Driver::cannot_shrink(double h, const Look& look) const {
  if (!look.lawful) return {Status::failed, fmt::format("at t = {:.6g} s: {}", t_, lawless_why_)};
  const std::string at = fmt::format(" at t = {:.6g} s with a step of {:.3g} s", t_, h);
  if (!look.trial.solved) return {Status::failed, look.trial.reason + at};
  return {Status::unstable,
          fmt::format("errors grow{}: the state at its end allows {:.3g} s", at, look.limit)};
}

Outcome Driver::too_short(std::string why) const {
  constexpr std::uint64_t recent = 100;  // steps
  const bool by_law = lawless_ > 0 && counted_.steps <= lawless_step_ + recent;
  if (by_law) why = fmt::format("at t = {:.6g} s: {}", t_, lawless_why_);
  return {Status::failed, std::move(why)};
}

void Driver::accept(const Step& step) {
  std::swap(state_, next_);
  counted_.steps += step.ends.size();
  t_ = step.ends.back();
  stepper_->accept(step, state_);
}

Outcome Driver::after_step() {
  if (recorder_.history()) {
    complete_state();
    recorder_.record(t_, state());
  }
  publish();
  note_extremes();
  settle_if_steady();
  if (Outcome outcome = may_go_on(); !outcome.ok()) return outcome;
  if (++since_look_ < RunGuard::stride) return {};
  return look_at(state_);
}

/// The step that the error allows is kept; the one taken is shortened to land.
double Driver::landing(double step, double limit, double target) const {
  const double remaining = target - t_;
  if (stepper_->worth_changing() > 1) return step >= remaining * (1 - 1e-10) ? remaining : step;
  const double stretched = std::min(limit, stepper_->convenient(step, limit));
  if (stretched >= remaining) return remaining;
  return stretched > 0.5 * remaining ? 0.5 * remaining : stretched;
}

Outcome Driver::take_controlled_steps(double target) {
  constexpr int most_rejections = 100;
  int rejected = 0;
  while (t_ < target) {
    const double limit = stepper_->longest_step(t_, state_);
    if (step_ == 0) step_ = first_step(std::min(limit, piece_end() - t_));
    step_ = std::min(step_, limit);
    const double h = landing(step_, limit, target);
    const double t_next = h == target - t_ ? target : t_ + h;
    ends_.assign(1, t_next);
    const Step step{t_, ends_};
    if (!(t_next > t_))
      return too_short(
          fmt::format("the step shrank to {:.3g} s at t = {:.6g} s without meeting the tolerance; "
                      "loosen rtol, or take another method",
                      h, t_));
    const Look look = try_step(step);
    // An estimate is never better than the roundings of what it is made from.
    constexpr double roundings = 8;
    const double error =
        std::max(roundings * task_.rounding, budget_.allowed(stepper_->share(), h, task_.t_end - t_));
    const double relative = look.trial.error / error;
    const bool good = look.trial.solved && look.stable && look.lawful && relative <= 1;
    if (!good) {
      ++counted_.rejected;
      if (++rejected > most_rejections || lawless_ > most_lawless) return cannot_shrink(h, look);
      if (!look.trial.solved)
        step_ = h * (look.trial.factor > 0 ? look.trial.factor : 0.25);
      else if (!look.stable || !look.lawful)
        step_ = h * (look.stable ? 0.5 : std::clamp(look.limit / h, smallest_shrink, 0.5));
      else
        step_ = controller_.after_rejection(h, relative);
      if (Outcome outcome = may_go_on(); !outcome.ok()) return outcome;
      continue;
    }
    rejected = 0;
    budget_.spend(look.trial.error);
    counted_.error_estimate = budget_.spent();
    double wanted = controller_.after_acceptance(h, relative);
    if (look.trial.factor > 0) wanted = std::min(wanted, look.trial.factor * h);
    const double worth = stepper_->worth_changing();
    if (worth > 1) {
      wanted = std::min(wanted, 5 * h);
      if (h == step_ && wanted < h) step_ = std::max(wanted, 0.5 * h);
      if (wanted > worth * step_) step_ = wanted;
    } else {  // a shortened step says nothing against the planned one
      step_ = h < step_ ? std::max(step_, wanted) : wanted;
    }
    accept(step);
    const Rhs* before = rhs_;
    if (Outcome outcome = after_step(); !outcome.ok()) return outcome;
    if (rhs_ != before) return {};
  }
  return {};
}

/// Tries a short Euler step and looks at how fast the derivative turns.
/// Source: Sommeijer, Shampine & Verwer (1998), doi:10.1016/S0377-0427(97)00219-7, section 2.3.
double Driver::first_step(double largest) {
  const double wish = stepper_->own_step(t_, state_);
  if (stepper_->pace() == OneStepMethod::Pace::method) return std::min(wish, largest);
  ErrorNorm norm;
  norm.prepare(*rhs_, task_.allowed);
  auto slope = stepper_->slope();
  if (slope.size() != state_.size()) {  // the method keeps none; a process may have no rows
    (*rhs_)(t_, state_, slope_);
    slope = slope_;
  }
  const double h = std::min(wish, largest);
  for_each_entry(next_.size(), [&](std::size_t i) { next_[i] = state_[i] + h * slope[i]; });
  (*rhs_)(t_ + h, next_, turned_);
  const double turn = norm.of([&](std::size_t i) { return h * (turned_[i] - slope[i]); }) / stepper_->share();
  if (!std::isfinite(turn)) return 1e-3 * h;
  if (0.1 * h < largest * std::sqrt(turn)) return std::max(0.1 * h / std::sqrt(turn), 1e-3 * h);
  return largest;
}

}  // namespace superstep
