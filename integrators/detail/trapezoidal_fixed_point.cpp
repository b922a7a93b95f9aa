#include "integrators/detail/trapezoidal_fixed_point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.hpp"

namespace superstep {
namespace {

constexpr double smallest_factor = 0.1, largest_factor = 2.0;
constexpr double largest_rejected_factor = 0.9;  // a rejected step must shrink

}  // namespace

void TrapezoidalFixedPoint::prepare(Rhs& rhs, const Plan& plan) {
  rhs_ = &rhs;
  track_inflow_ = plan.track_inflow;
  t_end_ = plan.output_times.back();
  guard_.prepare(rhs, plan);
  recorder_.prepare(plan);
  for (auto* v : {&state_, &derivative_, &iterate_, &iterate_before_}) v->resize(rhs.size());
  if (rhs.traits().linear) radius_ = spectral_radius_.at(rhs, plan.t_begin, state_);
}

void TrapezoidalFixedPoint::start(double t, std::span<const double> y) {
  t_ = t;
  rhs_->restart(t);
  std::copy(y.begin(), y.end(), state_.begin());
  (*rhs_)(t_, state_, derivative_);
  radius_ = spectral_radius_.at(*rhs_, t_, state_);
  const double contraction = settings_.rule.phi * radius_;
  step_ = contraction > 0 ? std::min(t_end_ - t, 0.5 / contraction) : t_end_ - t;
  statistics_ = {};
}

TrapezoidalFixedPoint::Iteration TrapezoidalFixedPoint::iterate(double h) {
  const auto& reduction = rhs_->reduction();
  const double phi = settings_.rule.phi, p = settings_.power;
  for_each_entry(iterate_.size(), [&](std::size_t i) { iterate_[i] = state_[i] + h * derivative_[i]; });
  double first_error = 0;
  for (int k = 1; k <= settings_.iterations; ++k) {
    std::swap(iterate_, iterate_before_);
    if (track_inflow_) inflow_rate_ = rhs_->inflow(t_ + h, iterate_before_);
    rhs_->stage(t_ + h,
                {.y1 = iterate_before_.data(),
                 .a = 0,
                 .d = phi * h,
                 .y2 = state_.data(),
                 .b = 1,
                 .y0 = state_.data(),
                 .c = 0,
                 .f0 = derivative_.data(),
                 .e = (1 - phi) * h},
                iterate_);
    statistics_.max_stages = std::max(statistics_.max_stages, k);
    const double change =
        reduction.sum([&](std::size_t i) { return std::abs(iterate_[i] - iterate_before_[i]); });
    const double moved = reduction.sum([&](std::size_t i) { return std::abs(iterate_[i] - state_[i]); });
    if (!std::isfinite(change)) return {false, smallest_factor};
    const double error = moved > 0 ? change / moved : 0;
    if (k == 1) first_error = error;
    const bool converged = error <= settings_.rule.rtol;
    if (!converged && k < settings_.iterations) continue;
    if (first_error == 0 || error == 0) return {converged, largest_factor};
    const double lambda = std::pow(settings_.rule.rtol / first_error, 1 / (p * settings_.iterations)) /
                          std::pow(error / first_error, 1 / (p * k));
    // After one iteration the observed contraction is unknown (w_K = w_0); the formula still asks for K_d
    // iterations.
    return {converged,
            std::clamp(lambda, smallest_factor, converged ? largest_factor : largest_rejected_factor)};
  }
  return {};
}

void TrapezoidalFixedPoint::accept(double t_next) {
  const double h = t_next - t_, phi = settings_.rule.phi;
  if (track_inflow_) statistics_.inflow += h * (phi * inflow_rate_ + (1 - phi) * rhs_->inflow(t_, state_));
  std::swap(state_, iterate_);
  t_ = t_next;
  (*rhs_)(t_, state_, derivative_);
  ++statistics_.steps;
  recorder_.record(t_, state_);
}

Outcome TrapezoidalFixedPoint::hopeless(double h) const {
  return {
      Status::failed,
      fmt::format(
          "phi h rho = {:.3g} >= 1 for h = {:.3g} s and rho = {:.4g} 1/s: the fixed-point iteration cannot "
          "contract; take a step below {:.3g} s, or solver=klu or pcg",
          settings_.rule.phi * h * radius_, h, radius_, 1 / (settings_.rule.phi * radius_))};
}

Outcome TrapezoidalFixedPoint::advance(double t_out) {
  const double fixed = settings_.rule.fixed_step;
  const double longest = fixed > 0 ? fixed : t_end_;
  if (fixed > 0) step_ = fixed;
  int rejected_in_a_row = 0;
  while (t_ < t_out) {
    const double remaining = t_out - t_;
    const double h = step_ >= remaining * (1 - 1e-12) ? remaining : step_;
    const Iteration result = iterate(h);
    if (guard_.stop_requested(t_)) return interrupted_at(t_);
    if (!result.converged) {
      ++statistics_.rejected;
      if (fixed > 0) {
        if (settings_.rule.phi * h * radius_ >= 1) return hopeless(h);
        return {Status::failed,
                fmt::format("not converged to {:.3g} in {} iterations at the fixed step {:.3g} s; allow "
                            "more iterations, or leave the step to the method",
                            settings_.rule.rtol, settings_.iterations, h)};
      }
      step_ = h * result.factor;
      constexpr int most_rejections = 60;
      if (++rejected_in_a_row > most_rejections || t_ + step_ <= t_)
        return {Status::failed,
                fmt::format("the step shrank to {:.3g} s at t = {:.6g} s and still does not converge; "
                            "the iteration stagnates above the tolerance {:.3g}",
                            step_, t_, settings_.rule.rtol)};
      continue;
    }
    rejected_in_a_row = 0;
    accept(h == remaining ? t_out : t_ + h);
    const double wanted = std::min(longest, h * result.factor);
    if (fixed == 0) step_ = h < step_ ? std::max(step_, wanted) : wanted;
    if (Outcome outcome = guard_.check(t_, state_); !outcome.ok()) return outcome;
  }
  return guard_.check(t_, state_);
}

}  // namespace superstep
