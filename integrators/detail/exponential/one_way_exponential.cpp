#include "integrators/detail/exponential/one_way_exponential.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "integrators/detail/driver/run_guard.hpp"
#include "integrators/detail/explicit/spectral_radius.hpp"
#include "integrators/detail/exponential/chebyshev_exponential.hpp"

namespace superstep {
namespace {

constexpr double share = 0.25;  // of the tolerance for each source of error
/// Of that for the potential: heat comes from differences between neighbours, and they may be small beside
/// the span. A digit more is a few terms.
constexpr double of_potential = 0.05;

/// Times of the Chebyshev-Lobatto points of a panel as parts of its length, 0 ... 1.
double point_position(std::size_t m, std::size_t degree) {
  return 0.5 * (1 - std::cos(std::numbers::pi * static_cast<double>(m) / static_cast<double>(degree)));
}

double rms(const Reduction& reduction, std::span<const double> v) {
  const double sum = reduction.sum([&](std::size_t i) { return v[i] * v[i]; });
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, reduction.total())));
}

/// Bound of an error's rms by its capacity-weighted rms [-].
double rms_over_weighted(const Rhs& rhs) {
  const auto capacity = rhs.capacities();
  const double total = rhs.reduction().sum([&](std::size_t i) { return capacity[i]; });
  const auto here = std::min_element(capacity.begin(), capacity.end());
  const double smallest =
      rhs.reduction().smallest(here == capacity.end() ? std::numeric_limits<double>::infinity() : *here);
  return std::sqrt(total / (static_cast<double>(rhs.reduction().total()) * smallest));
}

/// out[i] += factor * v[i], a stretch that stays in the first cache at a time.
void add(std::span<double> out, std::span<const double> v, double factor, std::size_t begin,
         std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) out[i] += factor * v[i];
}

constexpr std::size_t stretch = 1024;

}  // namespace

void OneWayExponential::prepare(Rhs& rhs, const Task& task) {
  rhs_ = &rhs;
  halves_ = rhs.one_way();
  plan_ = task.plan;
  driver_size_ = halves_->driver().size();
  driven_size_ = halves_->driven().size();
  state_.resize(rhs.size());
  const auto nodes = static_cast<std::size_t>(degree) + 1;
  point_.assign(nodes, std::vector<double>(driver_size_));
  heat_.assign(nodes, std::vector<double>(driven_size_));
  expansion_.assign(nodes, std::vector<double>(driven_size_));
  for (auto* v : {&u_, &next_}) v->resize(driver_size_);
  for (auto* v : {&y1_, &y2_, &input_, &input_slope_}) v->resize(driven_size_);
  SpectralRadius driver_radius, driven_radius;
  driver_radius.prepare(halves_->driver(), std::span(task.spans).first(1));
  driven_radius.prepare(halves_->driven(), std::span(task.spans).last(1));
  driver_radius_ = driver_radius.at(task.t_begin, potential());
  driven_radius_ = driven_radius.at(task.t_begin, temperature());
  potential_span_ = task.spans[0];
  temperature_span_ = task.spans[1];
  tolerance_ = rtol_;
  if (temperature_span_ > 0) tolerance_ = std::max(tolerance_, task.allowed[1] / temperature_span_);
  // Truncation is bounded in the capacity-weighted norm; driven small capacities may have all of its error.
  tolerance_ *=
      share / (static_cast<double>(task.propagations) *
               std::max(rms_over_weighted(halves_->driver()), rms_over_weighted(halves_->driven())));
}

void OneWayExponential::begin(double t, double /*end*/, std::span<const double> y,
                              std::span<const Instant> instants, bool /*smooth*/) {
  t_ = t;
  instants_ = instants;
  std::copy(y.begin(), y.end(), state_.begin());
  // Temperatures are propagated as differences from their mean: the expansion's rest is then one of the span.
  const auto& reduction = halves_->driven().reduction();
  offset_ =
      reduction.sum([&](std::size_t i) { return temperature()[i]; }) / static_cast<double>(reduction.total());
  const double whole = instants.empty() ? 0 : instants.back().t - t;
  panel_ = driver_radius_ > 0 ? std::min(whole, 8 / driver_radius_) : whole;
}

/// One panel.
Outcome OneWayExponential::advance(std::size_t k) {
  constexpr double longest_growth = 4, smallest_shrink = 0.25;
  const double allowed = tolerance_ * temperature_span_;
  while (true) {
    if (plan_->stop && plan_->stop->load()) return interrupted_at(t_);
    const double t_out = instants_[k].t, remaining = t_out - t_;
    const double h =
        panel_ >= remaining ? remaining : std::min(panel_, std::max(0.5 * remaining, 0.2 * panel_));
    find_inputs(h);
    propagate_potential(h);
    expand_heat(h);
    const double error = heat_error(h);
    const double factor = error > 0 ? 0.8 * std::pow(allowed / error, 1.0 / degree) : longest_growth;
    if (error > allowed) {
      ++counts_.rejected;
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
    ++counts_.steps;
    return {};
  }
}

void OneWayExponential::record_probes(ProbeHistory& history) {
  std::vector<double> values;
  for (const auto probe : plan_->probes) values.push_back(state_[probe]);
  history.append(t_, values);
}

void OneWayExponential::add_counts(Statistics& statistics) const {
  statistics.steps += counts_.steps;
  statistics.rejected += counts_.rejected;
  statistics.inflow += counts_.inflow;
  statistics.max_stages = std::max(statistics.max_stages, counts_.max_stages);
}

/// Inputs are linear in time on a panel: their effect at both ends says it all.
void OneWayExponential::find_inputs(double h) {
  Rhs& driven = halves_->driven();
  std::fill(y1_.begin(), y1_.end(), offset_);
  driven(t_, y1_, input_);
  if (driven.traits().autonomous) return std::fill(input_slope_.begin(), input_slope_.end(), 0.0);
  driven(t_ + h, y1_, input_slope_);
  for (std::size_t i = 0; i < driven_size_; ++i) {
    const double begin = input_[i], end = input_slope_[i];
    input_[i] = 0.5 * (begin + end);
    input_slope_[i] = 0.5 * (end - begin);
  }
}

/// Nothing exchanges anything: potentials follow their sources, which are linear in time.
void OneWayExponential::gain_potential(double h) {
  for (std::size_t m = 1; m <= degree; ++m) {
    const double elapsed = h * point_position(m, degree);
    halves_->driver()(t_ + 0.5 * elapsed, potential(), u_);
    for (std::size_t i = 0; i < driver_size_; ++i) point_[m][i] = potential()[i] + elapsed * u_[i];
  }
}

void OneWayExponential::propagate_potential(double h) {
  Rhs& rhs = halves_->driver();
  std::copy(potential().begin(), potential().end(), point_[0].begin());
  const double radius = driver_radius_;
  if (radius == 0) return gain_potential(h);
  const ExpansionScale scale = find_expansion_scale(rhs, t_, h, potential(), potential_span_, u_, next_);
  std::vector<std::vector<double>> c;
  for (std::size_t m = 1; m <= degree; ++m) {
    const double elapsed = h * point_position(m, degree);
    c.push_back(exponential_series(elapsed * radius / 2, of_potential * tolerance_, scale.over(elapsed)).c);
    std::fill(point_[m].begin(), point_[m].end(), 0.0);
  }
  const std::size_t terms = c.back().size();
  const auto coefficient = [&](std::size_t m, std::size_t k) {
    return k < c[m - 1].size() ? c[m - 1][k] : 0.0;
  };
  std::copy(potential().begin(), potential().end(), u_.begin());
  const auto time_of = [&](std::size_t k) {  // obeys the recurrence as an entry with rate 1 would
    return t_ + 2 * static_cast<double>(k * k) / radius;
  };
  rhs.stage(t_, {.y1 = u_.data(), .a = 1, .d = 2 / radius}, next_);
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
    rhs.stage(time_of(k + 1), {.y1 = next_.data(), .a = 2, .d = 4 / radius, .y2 = u_.data(), .b = -1}, u_);
    rhs.stage(time_of(k + 2), {.y1 = u_.data(), .a = 2, .d = 4 / radius, .y2 = next_.data(), .b = -1}, next_);
  }
  counts_.max_stages = std::max(counts_.max_stages, static_cast<int>(terms));
}

void OneWayExponential::expand_heat(double h) {
  for (std::size_t m = 0; m <= degree; ++m)
    halves_->rate(t_ + h * point_position(m, degree), point_[m], heat_[m]);
  // Interpolation in the Lobatto points x_m = -cos(m pi/n): r_p = 2/(n w_p) sum_m heat_m T_p(x_m)/w_m, w = 2
  // at both ends, else 1.
  const auto end_weight = [](std::size_t k) { return k == 0 || k == degree ? 2.0 : 1.0; };
  for (std::size_t p = 0; p <= degree; ++p) {
    auto& r = expansion_[p];
    if (p < 2)
      r.assign(p == 0 ? input_.begin() : input_slope_.begin(), p == 0 ? input_.end() : input_slope_.end());
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

/// What heat and inputs would change in the panel if nothing flowed off, in spans: what is left out of their
/// series is a part of that. Held temperatures and surroundings exchange many spans in a long panel.
double OneWayExponential::input_size(double h) const {
  const auto& reduction = halves_->driven().reduction();
  double rate = 0;
  for (const auto& r : expansion_) rate += rms(reduction, r);
  return temperature_span_ > 0 ? h * rate / temperature_span_ : 0;
}

void OneWayExponential::propagate_temperature(double h) {
  const DuhamelPanel panel{h, driven_radius_, degree};
  const std::size_t terms = duhamel_terms(panel, tolerance_ / std::max(1.0, input_size(h)));
  for (double& value : temperature()) value -= offset_;
  if (plan_->track_inflow) gain_inflow(h, panel, terms);
  clenshaw(end_coefficients(panel, terms), y1_);
  for (std::size_t i = 0; i < driven_size_; ++i) temperature()[i] = offset_ + y1_[i];
}

/// What Joule heat brought in, and what passed through fixed values and sources: the integral over the panel.
void OneWayExponential::gain_inflow(double h, const DuhamelPanel& panel, std::size_t terms) {
  const auto capacity = rhs_->capacities().subspan(driver_size_);
  const auto integral = chebyshev_integrals(degree);
  Rhs& driven = halves_->driven();
  for (std::size_t p = 0; p <= degree; ++p)
    counts_.inflow += h * integral[p] * driven.reduction().sum([&](std::size_t i) {
      const double input = p == 0 ? input_[i] : p == 1 ? input_slope_[i] : 0;
      return capacity[i] * (expansion_[p][i] - input);
    });
  std::fill(y1_.begin(), y1_.end(), offset_);
  const double at_offset = 0.5 * (driven.inflow(t_, y1_) + driven.inflow(t_ + h, y1_));
  clenshaw(integral_coefficients(panel, terms), y1_);
  counts_.inflow += h * at_offset + driven.linear_inflow(y1_);
}

/// Backward recurrence b_k = d_k + 2 X b_{k+1} - b_{k+2}, X = 1 - 2 A/rho; the sum is d_0 + X b_1 - b_2.
void OneWayExponential::clenshaw(const DuhamelCoefficients& coefficients, StateVector& out) {
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

}  // namespace superstep
