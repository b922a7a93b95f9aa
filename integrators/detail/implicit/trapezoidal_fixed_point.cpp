#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/parallel.hpp"
#include "integrators/detail/implicit/trapezoidal.hpp"

namespace superstep {
namespace {

constexpr double smallest_factor = 0.1, largest_factor = 2.0;
constexpr double largest_rejected_factor = 0.9;  // a rejected step must shrink

}  // namespace

void TrapezoidalFixedPoint::prepare(Rhs& rhs, const Task& task) {
  Trapezoidal::prepare(rhs, task);
  radius_.prepare(rhs, task.spans);
}

OneStepMethod::Pace TrapezoidalFixedPoint::pace() const {
  if (settings_.fixed_step > 0) return Pace::multiples;
  return iteration_.paper_control ? Pace::method : Pace::error;
}

double TrapezoidalFixedPoint::own_step(double t, std::span<const double> y) {
  if (settings_.fixed_step > 0) return settings_.fixed_step;
  const double contraction = settings_.phi * radius_.at(t, y);
  return contraction > 0 ? 0.5 / contraction : std::numeric_limits<double>::infinity();
}

/// Where the iteration cannot contract there is nothing to try.
double TrapezoidalFixedPoint::longest_step(double t, std::span<const double> y) {
  radius_now_ = radius_.at(t, y);
  const double contraction = settings_.phi * radius_now_;
  return contraction > 0 && !iteration_.paper_control ? 0.9 / contraction
                                                      : std::numeric_limits<double>::infinity();
}

Trial TrapezoidalFixedPoint::not_converged(double h, double factor) const {
  const double contraction = settings_.phi * h * radius_now_;
  if (contraction >= 1)
    return {.solved = false,
            .factor = factor,
            .reason = fmt::format("phi h rho = {:.3g} >= 1 with rho = {:.4g} 1/s: the fixed-point iteration "
                                  "cannot contract; take a step below {:.3g} s, or solver=klu or pcg",
                                  contraction, radius_now_, 1 / (settings_.phi * radius_now_))};
  return {
      .solved = false,
      .factor = factor,
      .reason = fmt::format("not converged to {:.3g} in {} iterations; allow more iterations, or leave the "
                            "step to the method",
                            settings_.rtol, iteration_.iterations)};
}

Trial TrapezoidalFixedPoint::attempt(const Step& step, StateVector& state, StateVector& next) {
  const auto& reduction = rhs_->reduction();
  const double h = step.h(), phi = settings_.phi, p = iteration_.power, t_next = step.ends.front();
  if (settings_.fixed_step > 0) radius_now_ = radius_.at(step.t, state);
  // Under error control the iteration ends well within what the step may err by; alone it rules by itself.
  const bool rules = iteration_.paper_control || settings_.fixed_step > 0;
  const double wanted = rules ? settings_.rtol : 1e-2 * share();
  StateVector &iterate = next, &before = base_;
  for_each_entry(iterate.size(), [&](std::size_t i) { iterate[i] = state[i] + h * slope_[i]; });
  double first_error = 0;
  for (int k = 1; k <= iteration_.iterations; ++k) {
    std::swap(iterate, before);
    rhs_->stage(t_next,
                {.y1 = before.data(),
                 .a = 0,
                 .d = phi * h,
                 .y2 = state.data(),
                 .b = 1,
                 .y0 = state.data(),
                 .c = 0,
                 .f0 = slope_.data(),
                 .e = (1 - phi) * h},
                iterate);
    most_iterations_ = std::max(most_iterations_, k);
    const auto change_at = [&](std::size_t i) { return iterate[i] - before[i]; };
    double error = 0;
    if (rules) {
      const double change = reduction.sum([&](std::size_t i) { return std::abs(change_at(i)); });
      const double moved = reduction.sum([&](std::size_t i) { return std::abs(iterate[i] - state[i]); });
      if (!std::isfinite(change)) return not_converged(h, smallest_factor);
      error = moved > 0 ? change / moved : 0;
    } else {
      error = norm_.of(change_at);
      if (!std::isfinite(error)) return not_converged(h, smallest_factor);
    }
    if (k == 1) first_error = error;
    const bool converged = error <= wanted;
    if (!converged && k < iteration_.iterations) continue;
    double factor = largest_factor;
    if (first_error > 0 && error > 0) {
      // After one iteration the contraction is unknown (w_K = w_0); the formula still asks for K_d
      // iterations.
      const double lambda = std::pow(wanted / first_error, 1 / (p * iteration_.iterations)) /
                            std::pow(error / first_error, 1 / (p * k));
      factor = std::clamp(lambda, smallest_factor, converged ? largest_factor : largest_rejected_factor);
    }
    if (!converged) return not_converged(h, factor);
    (*rhs_)(t_next, iterate, next_slope_);
    return {.error = rules ? 0 : milne_error(h, state, iterate), .factor = factor};
  }
  return not_converged(h, smallest_factor);
}

void TrapezoidalFixedPoint::add_counts(Statistics& statistics) const {
  statistics.max_stages = std::max(statistics.max_stages, most_iterations_);
}

}  // namespace superstep
