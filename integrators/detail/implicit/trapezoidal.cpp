#include "integrators/detail/implicit/trapezoidal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/parallel.hpp"

namespace superstep {

void Trapezoidal::prepare(Rhs& rhs, const Task& task) {
  rhs_ = &rhs;
  norm_.prepare(rhs, task.allowed);
  for (auto* v : {&slope_, &next_slope_, &earlier_slope_, &base_}) v->resize(rhs.size());
}

double Trapezoidal::own_step(double t, std::span<const double> y) {
  if (settings_.fixed_step > 0) return settings_.fixed_step;
  const double bound = rhs_->spectral_bound(t, y);
  return bound > 0 ? 1 / bound : std::numeric_limits<double>::infinity();
}

double Trapezoidal::share() const {
  const double rtol = settings_.rtol;
  return order() == 2 ? std::min(0.7, 30 * std::sqrt(rtol)) : std::min(0.25, 10 * rtol);
}

void Trapezoidal::restart(double t, std::span<const double> y, bool smooth) {
  (*rhs_)(t, y, slope_);
  if (!smooth) step_before_ = 0;
}

void Trapezoidal::accept(const Step& step, std::span<const double> /*state*/) {
  std::swap(earlier_slope_, slope_);
  std::swap(slope_, next_slope_);
  step_before_ = step.h();
}

void Trapezoidal::predict(double h, const StateVector& state, StateVector& next) const {
  const double r = step_before_ > 0 ? h / (2 * step_before_) : 0;
  for_each_entry(next.size(), [&](std::size_t i) {
    next[i] = state[i] + h * (slope_[i] + r * (slope_[i] - earlier_slope_[i]));
  });
}

double Trapezoidal::milne_error(double h, const StateVector& state, const StateVector& next) const {
  const bool first = step_before_ == 0;
  const double r = first ? 0 : h / (2 * step_before_);
  const double scale = first ? 0.5 : settings_.phi == 0.5 ? 1 / (3 * (1 + step_before_ / h)) : 1.0;
  return norm_.of([&](std::size_t i) {
    const double slope = slope_[i] + r * (slope_[i] - earlier_slope_[i]);
    return scale * (next[i] - state[i] - h * slope);
  });
}

void TrapezoidalNewton::prepare(Rhs& rhs, const Task& task) {
  Trapezoidal::prepare(rhs, task);
  const std::string solver = settings_.solver == "auto" ? fastest_linear_solver(rhs) : settings_.solver;
  if (settings_.solver == "auto") choice_ = "solver=" + solver;
  stage_.prepare(rhs, task, solver);
}

Trial TrapezoidalNewton::attempt(const Step& step, StateVector& state, StateVector& next) {
  const double h = step.h(), t_next = step.ends.front(), phi = settings_.phi;
  if (!stage_.set(phi * h, step.t, state))
    return {.solved = false, .reason = "the matrix cannot be factorized"};
  for_each_entry(state.size(), [&](std::size_t i) { base_[i] = state[i] + h * (1 - phi) * slope_[i]; });
  predict(h, state, next);
  const double precision = settings_.fixed_step > 0 ? 0 : 1e-2 * share();
  const auto result = stage_.solve(t_next, base_, precision, next, next_slope_);
  if (!result.solved) return {.solved = false, .reason = result.reason};
  return {.error = settings_.fixed_step > 0 ? 0 : milne_error(h, state, next)};
}

void TrapezoidalNewton::add_counts(Statistics& statistics) const {
  statistics.max_stages = std::max(statistics.max_stages, 1);
  stage_.add_counts(statistics);
}

}  // namespace superstep
