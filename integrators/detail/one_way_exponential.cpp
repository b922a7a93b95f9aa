#include "integrators/detail/one_way_exponential.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "integrators/detail/chebyshev_exponential.hpp"

namespace superstep {
namespace {

constexpr double share = 0.25;  // of the tolerance for each source of error

/// Times of the Chebyshev-Lobatto points of a panel as parts of its length, 0 ... 1.
double point_position(std::size_t m, std::size_t degree) {
  return 0.5 * (1 - std::cos(std::numbers::pi * static_cast<double>(m) / static_cast<double>(degree)));
}

double rms(const Reduction& reduction, std::span<const double> v) {
  const double sum = reduction.sum([&](std::size_t i) { return v[i] * v[i]; });
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, reduction.size())));
}

double span_of(const Plan& plan, Rhs& rhs, std::size_t field) {
  const double duration = plan.output_times.back() - plan.t_begin;
  return std::max(plan.ranges[field].span(), std::abs(rhs.mean_source_rate(field)) * duration);
}

/// out[i] += factor * v[i], a stretch that stays in the first cache at a time.
void add(std::span<double> out, std::span<const double> v, double factor, std::size_t begin,
         std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) out[i] += factor * v[i];
}

constexpr std::size_t stretch = 1024;

}  // namespace

void OneWayExponential::prepare(Rhs& rhs, const Plan& plan) {
  rhs_ = &rhs;
  halves_ = rhs.one_way();
  plan_ = plan;
  guard_.prepare(rhs, plan);
  recorder_.prepare(plan);
  driver_size_ = halves_->driver().size();
  driven_size_ = halves_->driven().size();
  state_.resize(rhs.size());
  derivative_.resize(driver_size_);
  const auto nodes = static_cast<std::size_t>(degree) + 1;
  point_.assign(nodes, std::vector<double>(driver_size_));
  heat_.assign(nodes, std::vector<double>(driven_size_));
  expansion_.assign(nodes, std::vector<double>(driven_size_));
  u_.resize(driver_size_);
  next_.resize(driver_size_);
  for (auto* v : {&y1_, &y2_, &constant_rate_}) v->resize(driven_size_);
  SpectralRadius driver_radius, driven_radius;
  driver_radius_ = driver_radius.at(halves_->driver(), plan.t_begin, potential());
  driven_radius_ = driven_radius.at(halves_->driven(), plan.t_begin, temperature());
  potential_span_ = span_of(plan, rhs, 0);
  temperature_span_ = span_of(plan, rhs, 1);
  Plan rest = plan;
  rest.history = nullptr;
  rest.probes.clear();
  rest.ranges = {{0, temperature_span_}};
  // Lanczos keeps the heat of an insulated network to its tolerance only, and converges faster than linearly:
  // three digits more cost a few vectors.
  rest_.emplace(std::max(1e-16, 1e-3 * share * rtol_));
  rest_->prepare(halves_->driven(), rest);
}

void OneWayExponential::start(double t, std::span<const double> y) {
  rhs_->restart(t);
  t_ = t;
  state_.assign(y.begin(), y.end());
  halves_->drive({});
  std::fill(y1_.begin(), y1_.end(), 0.0);
  halves_->driven()(t, y1_, constant_rate_);  // what fixed values and sources alone do
  halves_->driver()(t, potential(), derivative_);
  rate_of_potential_ = rms(halves_->driver().reduction(), derivative_);
  panel_ = driver_radius_ > 0 ? 8 / driver_radius_ : plan_.output_times.back() - t;
  steady_ = rate_of_potential_ == 0;
  if (steady_) halves_->rate(t, potential(), heat_[0]);
  rest_begins_ = true;
  inflow_before_ = 0;
  next_output_ = 0;
  statistics_ = {};
}

Outcome OneWayExponential::advance(double t_out) {
  constexpr double longest_growth = 4, smallest_shrink = 0.25;
  const double allowed = share * rtol_ * temperature_span_;
  while (t_ < t_out && !steady_) {
    if (guard_.stop_requested(t_)) return interrupted_at(t_);
    const double remaining = t_out - t_;
    const double h =
        panel_ >= remaining ? remaining : std::min(panel_, std::max(0.5 * remaining, 0.2 * panel_));
    propagate_potential(h);
    expand_heat(h);
    const double error = heat_error(h);
    const double factor = error > 0 ? 0.8 * std::pow(allowed / error, 1.0 / degree) : longest_growth;
    if (error > allowed) {
      ++statistics_.rejected;
      panel_ = h * std::clamp(factor, smallest_shrink, 0.7);
      if (t_ + panel_ <= t_)
        return {Status::failed, "the panels shrank to nothing: the Joule heat is not smooth in time"};
      continue;
    }
    propagate_temperature(h);
    std::copy(point_.back().begin(), point_.back().end(), potential().begin());
    t_ = h == remaining ? t_out : t_ + h;
    const double wanted = h * std::clamp(factor, smallest_shrink, longest_growth);
    panel_ = h < panel_ ? std::max(panel_, wanted) : wanted;
    ++statistics_.steps;
    recorder_.record(t_, state_);
    steady_ = potential_is_steady(h);
    if (!steady_) continue;
    halves_->rate(t_, potential(), heat_[0]);
    inflow_before_ = statistics_.inflow;
  }
  if (t_ < t_out)
    if (Outcome outcome = advance_with_constant_heat(t_out); !outcome.ok()) return outcome;
  ++next_output_;
  return guard_.check(t_, state_);
}

void OneWayExponential::propagate_potential(double h) {
  Rhs& rhs = halves_->driver();
  std::copy(potential().begin(), potential().end(), point_[0].begin());
  const double radius = driver_radius_;
  std::vector<std::vector<double>> c;
  for (std::size_t m = 1; m <= degree; ++m) {
    const double z = h * point_position(m, degree) * radius / 2;
    c.push_back(exponential_coefficients(z, share * rtol_, rhs.source_rate(0) > 0));
    std::fill(point_[m].begin(), point_[m].end(), 0.0);
  }
  const std::size_t terms = c.back().size();
  const auto coefficient = [&](std::size_t m, std::size_t k) {
    return k < c[m - 1].size() ? c[m - 1][k] : 0.0;
  };
  std::copy(potential().begin(), potential().end(), u_.begin());
  rhs.stage(t_, {.y1 = u_.data(), .a = 1, .d = radius > 0 ? 2 / radius : 0}, next_);
  for (std::size_t k = 0; k < terms; k += 2) {
    for (std::size_t begin = 0; begin < driver_size_; begin += stretch) {
      const std::size_t end = std::min(begin + stretch, driver_size_);
      for (std::size_t m = 1; m <= degree; ++m) {
        if (k >= c[m - 1].size()) continue;
        const double a = coefficient(m, k), b = coefficient(m, k + 1);
        for (std::size_t i = begin; i < end; ++i) point_[m][i] += a * u_[i] + b * next_[i];
      }
    }
    if (k + 2 >= terms) break;
    rhs.stage(t_, {.y1 = next_.data(), .a = 2, .d = 4 / radius, .y2 = u_.data(), .b = -1}, u_);
    rhs.stage(t_, {.y1 = u_.data(), .a = 2, .d = 4 / radius, .y2 = next_.data(), .b = -1}, next_);
  }
  statistics_.max_stages = std::max(statistics_.max_stages, static_cast<int>(terms));
}

void OneWayExponential::expand_heat(double h) {
  for (std::size_t m = 0; m <= degree; ++m)
    halves_->rate(t_ + h * point_position(m, degree), point_[m], heat_[m]);
  // Interpolation in the Lobatto points x_m = -cos(m pi/n): r_p = 2/(n w_p) sum_m heat_m T_p(x_m)/w_m, w = 2
  // at both ends, else 1.
  const auto end_weight = [](std::size_t k) { return k == 0 || k == degree ? 2.0 : 1.0; };
  for (std::size_t p = 0; p <= degree; ++p) {
    auto& r = expansion_[p];
    if (p == 0)
      r = constant_rate_;
    else
      std::fill(r.begin(), r.end(), 0.0);
    for (std::size_t m = 0; m <= degree; ++m) {
      const double angle = std::numbers::pi * static_cast<double>(p * (degree - m)) / degree;
      const double factor = 2 * std::cos(angle) / (degree * end_weight(p) * end_weight(m));
      add(r, heat_[m], factor, 0, driven_size_);
    }
  }
}

double OneWayExponential::heat_error(double h) const {
  const auto& reduction = halves_->driven().reduction();
  return 0.5 * h * (rms(reduction, expansion_[degree]) + rms(reduction, expansion_[degree - 1]));
}

void OneWayExponential::propagate_temperature(double h) {
  const DuhamelPanel panel{h, driven_radius_, degree};
  const std::size_t terms = duhamel_terms(panel, share * rtol_);
  if (plan_.track_inflow) gain_inflow(h, panel, terms);
  clenshaw(end_coefficients(panel, terms), y1_);
  std::copy(y1_.begin(), y1_.end(), temperature().begin());
}

/// What Joule heat brought in, and what passed through fixed values and sources: the integral over the panel.
void OneWayExponential::gain_inflow(double h, const DuhamelPanel& panel, std::size_t terms) {
  const auto capacity = rhs_->capacities().subspan(driver_size_);
  const auto integral = chebyshev_integrals(degree);
  Rhs& driven = halves_->driven();
  for (std::size_t p = 0; p <= degree; ++p)
    statistics_.inflow += h * integral[p] * driven.reduction().sum([&](std::size_t i) {
      const double constant = p == 0 ? constant_rate_[i] : 0;
      return capacity[i] * (expansion_[p][i] - constant);
    });
  std::fill(y1_.begin(), y1_.end(), 0.0);
  const double at_zero = driven.inflow(t_, y1_);
  clenshaw(integral_coefficients(panel, terms), y1_);
  statistics_.inflow += h * at_zero + driven.linear_inflow(y1_);
}

/// Backward recurrence b_k = d_k + 2 X b_{k+1} - b_{k+2}, X = 1 - 2 A/rho; the sum is d_0 + X b_1 - b_2.
void OneWayExponential::clenshaw(const DuhamelCoefficients& coefficients, std::vector<double>& out) {
  Rhs& rhs = halves_->driven();
  const double slope = driven_radius_ > 0 ? 2 / driven_radius_ : 0;
  const auto source_terms = [&](std::size_t k, std::span<double> target) {
    for (std::size_t begin = 0; begin < driven_size_; begin += stretch) {
      const std::size_t end = std::min(begin + stretch, driven_size_);
      add(target, temperature(), coefficients.state[k], begin, end);
      for (std::size_t p = 0; p <= degree; ++p)
        add(target, expansion_[p], coefficients.source[p][k], begin, end);
    }
  };
  std::fill(y1_.begin(), y1_.end(), 0.0);
  std::fill(y2_.begin(), y2_.end(), 0.0);
  for (std::size_t k = coefficients.state.size() - 1; k > 0; --k) {
    rhs.linear_stage({.y1 = y1_.data(), .a = 2, .d = 2 * slope, .y2 = y2_.data(), .b = -1}, y2_);
    source_terms(k, y2_);
    std::swap(y1_, y2_);
  }
  rhs.linear_stage({.y1 = y1_.data(), .a = 1, .d = slope, .y2 = y2_.data(), .b = -1}, y2_);
  source_terms(0, y2_);
  if (&out != &y2_) std::swap(out, y2_);
}

bool OneWayExponential::potential_is_steady(double h) {
  halves_->driver()(t_, potential(), derivative_);
  const double before = std::exchange(rate_of_potential_, rms(halves_->driver().reduction(), derivative_));
  if (rate_of_potential_ == 0) return true;
  const double decay = std::log(before / rate_of_potential_) / h;
  // Late in the transient its slowest mode is left: what is still to come is rate/decay.
  return decay > 0 && rate_of_potential_ / decay <= share * rtol_ * potential_span_;
}

Outcome OneWayExponential::advance_with_constant_heat(double t_out) {
  halves_->drive(heat_[0]);
  if (rest_begins_) rest_->start_at(t_, temperature(), next_output_);
  rest_begins_ = false;
  const Outcome outcome = rest_->advance(t_out);
  halves_->drive({});
  if (!outcome.ok()) return outcome;
  std::copy(rest_->state().begin(), rest_->state().end(), temperature().begin());
  statistics_.inflow = inflow_before_ + rest_->statistics().inflow;
  statistics_.max_stages = std::max(statistics_.max_stages, rest_->statistics().max_stages);
  ++statistics_.steps;
  t_ = t_out;
  recorder_.record(t_, state_);
  return outcome;
}

}  // namespace superstep
