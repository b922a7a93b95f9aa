#include "integrators/detail/trapezoidal_newton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace superstep {
namespace {

constexpr int most_newton_iterations = 8;

}  // namespace

TrapezoidalNewton::TrapezoidalNewton(const TrapezoidalSettings& settings, std::string solver)
    : settings_(settings), solver_name_(std::move(solver)), controller_(settings.phi == 0.5 ? 2 : 1) {}

void TrapezoidalNewton::prepare(Rhs& rhs, const Plan& plan) {
  rhs_ = &rhs;
  track_inflow_ = plan.track_inflow;
  t_end_ = plan.output_times.back();
  guard_.prepare(rhs, plan);
  recorder_.prepare(plan);
  weights_.prepare(rhs, plan, settings_.rtol, settings_.atol);
  for (auto* v :
       {&state_, &next_, &derivative_, &next_derivative_, &earlier_derivative_, &residual_, &change_})
    v->resize(rhs.size());
  const std::string solver = solver_name_ == "auto" ? fastest_linear_solver(rhs) : solver_name_;
  if (solver_name_ == "auto") choice_ = "solver=" + solver;
  solver_ = make_shifted_solver(solver, rhs);
}

void TrapezoidalNewton::start(double t, std::span<const double> y) {
  t_ = t;
  rhs_->restart(t);
  std::copy(y.begin(), y.end(), state_.begin());
  (*rhs_)(t_, state_, derivative_);
  weights_.restart();
  controller_.restart();
  solver_->reset_counts();
  statistics_ = {};
  step_ = step_before_ = 0;
}

Outcome TrapezoidalNewton::advance(double t_out) {
  Outcome outcome = settings_.fixed_step > 0 ? advance_fixed(t_out) : advance_controlled(t_out);
  statistics_.factorizations = solver_->factorizations();
  statistics_.solves = solver_->solves();
  return outcome;
}

Outcome TrapezoidalNewton::try_step(double h) {
  const double c = settings_.phi * h;
  if (!solver_->set(c, t_ + h, state_))
    return {Status::failed,
            fmt::format("the matrix of a step of {:.3g} s cannot be factorized at t = {:.6g} s", h, t_)};
  next_ = state_;
  next_derivative_ = derivative_;
  const bool linear = rhs_->traits().linear && rhs_->traits().autonomous;
  // Newton from the old state; a linear scene is solved by the first iteration.
  const double solve_tolerance = settings_.fixed_step > 0 ? 1e-12 : 1e-3 * settings_.rtol;
  for (int k = 0; k < most_newton_iterations; ++k) {
    for (std::size_t i = 0; i < residual_.size(); ++i)
      residual_[i] = state_[i] - next_[i] +
                     h * ((1 - settings_.phi) * derivative_[i] + settings_.phi * next_derivative_[i]);
    if (!solver_->solve(residual_, change_, solve_tolerance))
      return {Status::failed, fmt::format("the linear solver did not converge at t = {:.6g} s", t_)};
    for (std::size_t i = 0; i < next_.size(); ++i) next_[i] += change_[i];
    (*rhs_)(t_ + h, next_, next_derivative_);
    if (linear) return {};
    weights_.widen(next_);
    if (weights_.norm([&](std::size_t i) { return change_[i]; }, state_, next_) < 0.01) return {};
  }
  return {Status::failed,
          fmt::format("Newton's iteration did not converge at t = {:.6g} s with a step of {:.3g} s", t_, h)};
}

void TrapezoidalNewton::accept(double t_next) {
  const double h = t_next - t_;
  if (track_inflow_)
    statistics_.inflow +=
        h * ((1 - settings_.phi) * rhs_->inflow(t_, state_) + settings_.phi * rhs_->inflow(t_next, next_));
  std::swap(state_, next_);
  std::swap(earlier_derivative_, derivative_);
  std::swap(derivative_, next_derivative_);
  step_before_ = h;
  t_ = t_next;
  ++statistics_.steps;
  statistics_.max_stages = 1;
  recorder_.record(t_, state_);
}

Outcome TrapezoidalNewton::advance_fixed(double t_out) {
  const double t_in = t_;
  const auto steps = steps_to_cover(t_out - t_in, settings_.fixed_step);
  // Equal steps up to the output time: one factorization for all of them.
  const double h = (t_out - t_in) / static_cast<double>(steps);
  for (std::uint64_t k = 1; k <= steps; ++k) {
    if (Outcome outcome = try_step(h); !outcome.ok()) return outcome;
    accept(k == steps ? t_out : t_in + static_cast<double>(k) * h);
    if (guard_.stop_requested(t_)) return interrupted_at(t_);
    if (Outcome outcome = guard_.check(t_, state_); !outcome.ok()) return outcome;
  }
  return guard_.check(t_, state_);
}

double TrapezoidalNewton::first_step(double largest) {
  const double rate = weights_.norm([&](std::size_t i) { return derivative_[i]; }, state_, state_);
  // A step over which the fastest change stays a small part of the tolerance's square root.
  return rate > 0 ? std::min(largest, 0.01 / (rate * std::sqrt(settings_.rtol))) : largest;
}

/// Difference to the second-order Adams-Bashforth predictor; for phi = 0.5 divided by 3 (1 + h_{n-1}/h_n).
double TrapezoidalNewton::milne_error(double h) {
  const bool first = step_before_ == 0;
  const double r = first ? 0 : h / (2 * step_before_);
  const double scale = first ? 0.5 : settings_.phi == 0.5 ? 1 / (3 * (1 + step_before_ / h)) : 1.0;
  weights_.widen(next_);
  return weights_.norm(
      [&](std::size_t i) {
        const double slope = derivative_[i] + r * (derivative_[i] - earlier_derivative_[i]);
        return scale * (next_[i] - state_[i] - h * slope);
      },
      state_, next_);
}

Outcome TrapezoidalNewton::advance_controlled(double t_out) {
  constexpr double worth_refactoring = 1.5;
  if (step_ == 0) step_ = first_step(t_end_ - t_);
  while (t_ < t_out) {
    const double remaining = t_out - t_;
    const double h = step_ >= remaining * (1 - 1e-10) ? remaining : step_;
    if (t_ + h <= t_)
      return {Status::failed, fmt::format("the step shrank to {:.3g} s at t = {:.6g} s; loosen rtol", h, t_)};
    if (Outcome outcome = try_step(h); !outcome.ok()) return outcome;
    const double error = milne_error(h);
    if (guard_.stop_requested(t_)) return interrupted_at(t_);
    if (!(error <= 1)) {
      ++statistics_.rejected;
      step_ = controller_.after_rejection(h, error);
      continue;
    }
    accept(h == remaining ? t_out : t_ + h);
    const double wanted = std::min(controller_.after_acceptance(h, error), 5 * h);
    if (h == step_ && wanted < h) step_ = std::max(wanted, 0.5 * h);
    if (wanted > worth_refactoring * step_) step_ = wanted;
    if (Outcome outcome = guard_.check(t_, state_); !outcome.ok()) return outcome;
  }
  return guard_.check(t_, state_);
}

}  // namespace superstep
