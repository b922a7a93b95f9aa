#include "integrators/detail/stabilised.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/parallel.hpp"

namespace superstep {
namespace {

constexpr int radius_refresh = 25;  // accepted steps, for scenes whose conductances change

}  // namespace

std::vector<OptionKey> stabilised_keys(const StabilisedFamily& family, bool two_orders) {
  std::vector<OptionKey> keys = tolerance_keys("1e-4");
  keys.push_back(
      {.name = "step", .min = 0, .min_open = true, .unit = "s", .meaning = "fixed step instead of rtol"});
  keys.push_back({.name = "stages",
                  .type = OptionKey::Type::integer,
                  .min = static_cast<double>(two_orders ? 1 : family.fewest_stages),
                  .max = static_cast<double>(family.most_stages),
                  .fallback = "as stability asks",
                  .meaning = "with step: fixed number of stages"});
  if (two_orders)
    keys.push_back({.name = "order",
                    .type = OptionKey::Type::integer,
                    .min = 1,
                    .max = 2,
                    .fallback = "2",
                    .meaning = "order in time"});
  return keys;
}

Stabilised::Stabilised(const StabilisedFamily& family, const Options& options)
    : family_(family),
      rtol_(options.number("rtol").value_or(1e-4)),
      atol_(options.number("atol").value_or(0.0)),
      fixed_step_(options.number("step").value_or(0.0)),
      fixed_stages_(options.integer("stages").value_or(0)),
      controller_(family.controlled_order) {
  static const std::array<std::string, 2> with_rtol = {"rtol", "step"}, with_atol = {"atol", "step"};
  options.at_most_one_of(with_rtol);
  options.at_most_one_of(with_atol);
  if (fixed_stages_ == 0) return;
  if (!(fixed_step_ > 0))
    throw UsageError(
        fmt::format("{}: stages goes with step; add step=..., or leave stages out", options.spec().name));
  const bool odd_needed = family.stage_step == 2 && fixed_stages_ % 2 == 0;
  if (fixed_stages_ < family.fewest_stages || odd_needed)
    throw UsageError(fmt::format("{}: stages = {} is not valid; it must be {}>= {}", options.spec().name,
                                 fixed_stages_, family.stage_step == 2 ? "odd and " : "",
                                 family.fewest_stages));
}

void Stabilised::prepare(Rhs& rhs, const Plan& plan) {
  rhs_ = &rhs;
  track_inflow_ = plan.track_inflow;
  t_end_ = plan.output_times.back();
  guard_.prepare(rhs, plan);
  recorder_.prepare(plan);
  weights_.prepare(rhs, plan, rtol_, atol_);
  state_.resize(rhs.size());
  derivative_.resize(rhs.size());
  next_derivative_.resize(rhs.size());
  const bool finishing = family_.order == 4;
  engine_.resize(rhs.size(), finishing);
  // A nonlinear right-hand side sees the state with its roundings, not only the change within the step.
  constexpr double state_over_change = 16;
  const bool by_change = rhs.traits().linear && rhs.traits().autonomous;
  stage_limit_ = family_.stages_within_rounding(finishing && !by_change ? rtol_ / state_over_change : rtol_);
  for (auto* v : {&scheme_.m, &scheme_.n, &scheme_.mt, &scheme_.gt, &scheme_.c})
    v->reserve(static_cast<std::size_t>(family_.most_stages) + 1);
  if (needs_radius() && rhs.traits().linear) radius_ = spectral_radius_.at(rhs, plan.t_begin, state_);
}

void Stabilised::start(double t, std::span<const double> y) {
  t_ = t;
  rhs_->restart(t);
  state_.assign(y.begin(), y.end());
  statistics_ = {};
  if (needs_radius()) radius_ = spectral_radius_.at(*rhs_, t, state_);
  steps_since_radius_ = 0;
  weights_.restart();
  controller_.restart();
  step_ = 0;  // chosen at the first advance
  scheme_.stages = 0;
  const bool needs_derivative = fixed_step_ == 0 || family_.order >= 2;
  if (needs_derivative) (*rhs_)(t_, state_, derivative_);
}

Outcome Stabilised::advance(double t_out) {
  return fixed_step_ > 0 ? advance_fixed(t_out) : advance_adaptive(t_out);
}

void Stabilised::set_stages(int stages) {
  if (scheme_.stages != stages) family_.build(stages, scheme_);
  statistics_.max_stages = std::max(statistics_.max_stages, stages);
}

/// The stages that a step needs are enough for a slightly longer one; taking it wastes no sweep, and the
/// controller's safety factor covers the difference.
double Stabilised::with_full_stages(double h) const {
  constexpr double longest_stretch = 1.1;
  if (!(radius_ > 0)) return h;
  return std::min(longest_stretch * h, family_.beta(family_.stages_for(h * radius_)) / radius_);
}

void Stabilised::try_step(double h) {
  set_stages(fixed_stages_ > 0 ? fixed_stages_ : family_.stages_for(h * radius_));
  trial_inflow_ = 0;
  engine_.step(*rhs_, scheme_, t_, h, state_, derivative_, track_inflow_ ? &trial_inflow_ : nullptr);
}

void Stabilised::accept(double t_next) {
  std::swap(state_, engine_.result());
  statistics_.inflow += trial_inflow_;
  ++statistics_.steps;
  t_ = t_next;
  recorder_.record(t_, state_);
  if (needs_radius() && !rhs_->traits().linear && ++steps_since_radius_ >= radius_refresh) {
    radius_ = spectral_radius_.at(*rhs_, t_, state_);
    steps_since_radius_ = 0;
  }
}

/// A field that has settled leaves a smaller spectrum and its own derivative behind.
void Stabilised::look_for_settling() {
  // What the method leaves behind stays well below its tolerance.
  constexpr double part_of_tolerance = 0.1;
  if (!rhs_->settle(t_, state_, fixed_step_ > 0 ? 0 : part_of_tolerance * rtol_)) return;
  if (needs_radius()) radius_ = spectral_radius_.at(*rhs_, t_, state_);
  (*rhs_)(t_, state_, derivative_);
}

Outcome Stabilised::advance_fixed(double t_out) {
  const double t_in = t_;
  const auto steps = steps_to_cover(t_out - t_in, fixed_step_);
  for (std::uint64_t k = 1; k <= steps; ++k) {
    const double t_next = k == steps ? t_out : t_in + static_cast<double>(k) * fixed_step_;
    if (fixed_stages_ == 0 && family_.stages_for((t_next - t_) * radius_) > family_.most_stages)
      return {Status::failed, fmt::format("a step of {:.3g} s needs more than {} stages; take a smaller step",
                                          fixed_step_, family_.most_stages)};
    try_step(t_next - t_);
    accept(t_next);
    if (scheme_.uses_first_derivative) (*rhs_)(t_, state_, derivative_);
    look_for_settling();
    if (guard_.stop_requested(t_)) return interrupted_at(t_);
    if (Outcome outcome = guard_.check(t_, state_); !outcome.ok()) return outcome;
  }
  return guard_.check(t_, state_);
}

double Stabilised::first_step(double largest) {
  // Try 1/rho and look at how fast the derivative turns.
  double h = radius_ > 0 ? std::min(largest, 1 / radius_) : largest;
  auto& trial = engine_.result();
  for_each_entry(trial.size(), [&](std::size_t i) { trial[i] = state_[i] + h * derivative_[i]; });
  (*rhs_)(t_ + h, trial, next_derivative_);
  weights_.widen(trial);
  const double turn =
      weights_.norm([&](std::size_t i) { return h * (next_derivative_[i] - derivative_[i]); }, state_, trial);
  if (0.1 * h < largest * std::sqrt(turn)) return std::max(0.1 * h / std::sqrt(turn), 1e-3 * h);
  return largest;
}

double Stabilised::estimate_error_of_finish(double h) {
  const auto& b = scheme_.finish->embedded;
  const auto& [f1, f2, f3, f4] = engine_.slopes();
  const auto& next = engine_.result();
  return scheme_.finish->estimate_scale *
         weights_.norm(
             [&](std::size_t i) {
               return next[i] - state_[i] - h * (b[0] * f1[i] + b[1] * f2[i] + b[2] * f3[i] + b[3] * f4[i]);
             },
             state_, next);
}

/// Weighted error of the trial step, from its finishing procedure when it has one, else from both ends'
/// derivatives:
///   order 2: 12 (1/6 - c_3) ((y_n - y_{n+1}) + h/2 (F_n + F_{n+1})),  order 1: (1/2 - c_2) h (F_{n+1} - F_n)
/// with c_k the Taylor coefficients of the scheme's own stability polynomial.
double Stabilised::estimate_error(double h) {
  const auto& y = state_;
  const auto& next = engine_.result();
  weights_.widen(next);
  if (scheme_.finish) return estimate_error_of_finish(h);
  (*rhs_)(t_ + h, next, next_derivative_);
  if (family_.order == 1) {
    const double factor = (0.5 - taylor_coefficient(scheme_, 2)) * h;
    return weights_.norm([&](std::size_t i) { return factor * (next_derivative_[i] - derivative_[i]); }, y,
                         next);
  }
  const double factor = 12 * (1.0 / 6.0 - taylor_coefficient(scheme_, 3));
  return weights_.norm(
      [&](std::size_t i) {
        return factor * (y[i] - next[i] + h / 2 * (derivative_[i] + next_derivative_[i]));
      },
      y, next);
}

Outcome Stabilised::advance_adaptive(double t_out) {
  if (step_ == 0) step_ = first_step(t_end_ - t_);
  while (t_ < t_out) {
    const double limit = radius_ > 0 ? family_.beta(stage_limit_) / radius_ : step_;
    step_ = std::min(step_, limit);
    // The step that the error allows is kept; the one taken is shortened to land on the output time.
    const double remaining = t_out - t_;
    const double stretched = std::min(limit, with_full_stages(step_));
    const double h = stretched >= remaining        ? remaining
                     : stretched > 0.5 * remaining ? 0.5 * remaining
                                                   : stretched;
    if (t_ + h <= t_)
      return {Status::failed,
              fmt::format("the step shrank to {:.3g} s at t = {:.6g} s without meeting the tolerance; "
                          "loosen rtol",
                          h, t_)};
    try_step(h);
    const double error = estimate_error(h);
    if (!(error <= 1)) {
      ++statistics_.rejected;
      step_ = controller_.after_rejection(h, error);
      radius_ = spectral_radius_.at(*rhs_, t_, state_);
      if (guard_.stop_requested(t_)) return interrupted_at(t_);
      continue;
    }
    accept(h == remaining ? t_out : t_ + h);
    if (scheme_.finish) (*rhs_)(t_, state_, next_derivative_);
    std::swap(derivative_, next_derivative_);
    look_for_settling();
    const double next_step = controller_.after_acceptance(h, error);
    step_ = h < step_ ? std::max(step_, next_step)
                      : next_step;  // a shortened step says nothing against the planned one
    if (guard_.stop_requested(t_)) return interrupted_at(t_);
    if (Outcome outcome = guard_.check(t_, state_); !outcome.ok()) return outcome;
  }
  return guard_.check(t_, state_);
}

}  // namespace superstep
