#include "integrators/detail/explicit/stabilised.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "integrators/detail/tolerance.hpp"

namespace superstep {

std::vector<OptionKey> stabilised_keys(const OfferedFamilies& families) {
  std::vector<OptionKey> keys = {tolerance_key("1e-4")};
  int fewest = families.front()->fewest_stages, most = families.front()->most_stages;
  for (const auto* family : families) {
    fewest = std::min(fewest, family->fewest_stages);
    most = std::max(most, family->most_stages);
  }
  keys.push_back(fixed_step_key());
  keys.push_back({.name = "stages",
                  .type = OptionKey::Type::integer,
                  .min = static_cast<double>(fewest),
                  .max = static_cast<double>(most),
                  .fallback = "as stability asks",
                  .meaning = "with step: fixed number of stages"});
  if (families.size() == 1) return keys;
  OptionKey order{.name = "order", .type = OptionKey::Type::word, .meaning = "order in time"};
  for (const auto* family : families) order.words.push_back(std::to_string(family->order));
  order.fallback = order.words.back();
  keys.push_back(std::move(order));
  return keys;
}

std::unique_ptr<Method> make_stabilised(const OfferedFamilies& families, const Options& options) {
  const auto* family = families.back();
  if (families.size() > 1)
    family = *std::find_if(families.begin(), families.end(), [&](const StabilisedFamily* one) {
      return std::to_string(one->order) == options.word("order");
    });
  return std::make_unique<Stabilised>(*family, options);
}

Stabilised::Stabilised(const StabilisedFamily& family, const Options& options)
    : family_(family),
      rtol_(options.number("rtol")),
      fixed_step_(fixed_step_of(options)),
      fixed_stages_(static_cast<int>(options.given("stages").value_or(0))) {
  if (fixed_stages_ == 0) return;
  if (!(fixed_step_ > 0))
    throw UsageError(
        fmt::format("{}: stages goes with step; add step=..., or leave stages out", options.spec().name));
  const bool odd_needed = family.stage_step == 2 && fixed_stages_ % 2 == 0;
  if (fixed_stages_ < family.fewest_stages || fixed_stages_ > family.most_stages || odd_needed)
    throw UsageError(fmt::format("{}: stages = {} is not valid; it must be {}from {} to {} at order {}",
                                 options.spec().name, fixed_stages_, family.stage_step == 2 ? "odd and " : "",
                                 family.fewest_stages, family.most_stages, family.order));
}

void Stabilised::prepare(Rhs& rhs, const Task& task) {
  rhs_ = &rhs;
  norm_.prepare(rhs, task.allowed);
  radius_.prepare(rhs, task.spans);
  engine_.resize(rhs.size(), family_.order == 4);
  for (auto* v : {&derivative_, &next_derivative_}) v->resize(rhs.size());
  // A nonlinear right-hand side sees the state with its roundings, not only the change within the step.
  constexpr double state_over_change = 16;
  const bool multiplies = family_.stiff_end > 0;
  const double of_values = task.rounding > 0 ? std::numeric_limits<double>::epsilon() / task.rounding : rtol_;
  stage_limit_ = family_.stages_within_rounding(!multiplies              ? of_values
                                                : evaluates_changes(rhs) ? rtol_
                                                                         : of_values / state_over_change);
  for (auto* v : {&scheme_.m, &scheme_.n, &scheme_.mt, &scheme_.gt, &scheme_.c})
    v->reserve(static_cast<std::size_t>(family_.most_stages) + 1);
  scheme_.stages = 0;
}

double Stabilised::own_step(double t, std::span<const double> y) {
  if (fixed_step_ > 0) return fixed_step_;
  const double radius = radius_.at(t, y);
  return radius > 0 ? 1 / radius : std::numeric_limits<double>::infinity();
}

double Stabilised::longest_step(double t, std::span<const double> y) {
  radius_now_ = radius_.at(t, y);
  return radius_now_ > 0 ? family_.beta(stage_limit_) / radius_now_ : std::numeric_limits<double>::infinity();
}

double Stabilised::stable_step(double t, std::span<const double> y) {
  const double radius = radius_.at(t, y);
  return radius > 0 ? scheme_.beta / radius : std::numeric_limits<double>::infinity();
}

/// The stages that a step needs are enough for a slightly longer one; taking it wastes no sweep, and the
/// controller's safety factor covers the difference.
double Stabilised::convenient(double h, double longest) const {
  constexpr double longest_stretch = 1.1;
  if (!(radius_now_ > 0)) return h;
  const double full = family_.beta(family_.stages_for(std::min(h, longest) * radius_now_)) / radius_now_;
  return std::min(longest_stretch * h, full);
}

/// Local errors add up to about a multiple of (local tolerance)^(p/(p+1)) on relaxing networks: a step's
/// share grows with rtol^(1/p). The constants are measured by the audit (tests/audit).
double Stabilised::share() const {
  if (family_.order == 4) return std::min(1.0, 0.15 * std::pow(rtol_, -0.1));
  return family_.order == 1 ? std::min(0.25, 10 * rtol_) : std::min(0.7, 30 * std::sqrt(rtol_));
}

void Stabilised::restart(double t, std::span<const double> y, bool /*smooth*/) {
  if (fixed_step_ == 0 || family_.order >= 2) (*rhs_)(t, y, derivative_);
}

Trial Stabilised::attempt(const Step& step, StateVector& state, StateVector& next) {
  const double h = step.h();
  if (fixed_stages_ == 0 && fixed_step_ > 0) radius_now_ = radius_.at(step.t, state);
  const int stages = fixed_stages_ > 0 ? fixed_stages_ : family_.stages_for(h * radius_now_);
  if (stages > family_.most_stages)
    return {
        .solved = false,
        .reason = fmt::format("more than {} stages are needed; take a smaller step", family_.most_stages)};
  if (scheme_.stages != stages) family_.build(stages, scheme_);
  most_stages_ = std::max(most_stages_, stages);
  engine_.step(*rhs_, scheme_, step.t, h, state, derivative_);
  std::swap(next, engine_.result());
  if (fixed_step_ > 0) return {};
  return {.error =
              scheme_.finish ? estimate_error_of_finish(h, state, next) : estimate_error(step, state, next)};
}

double Stabilised::estimate_error_of_finish(double h, const StateVector& y, const StateVector& next) const {
  const auto& b = scheme_.finish->embedded;
  const auto& f = engine_.slopes();
  // The estimate is that of the embedded result of order three, which is given up for the one of order four.
  // Where inputs move it is less good than elsewhere, and where laws bend it need not be better at all.
  const RhsTraits& traits = rhs_->traits();
  const double given_up = !traits.smooth ? 1 : traits.autonomous ? 0.2 : 0.3;
  return given_up * scheme_.finish->estimate_scale * norm_.of([&](std::size_t i) {
    return next[i] - y[i] - h * (b[0] * f[0][i] + b[1] * f[1][i] + b[2] * f[2][i] + b[3] * f[3][i]);
  });
}

/// Error of the trial step from the derivatives at both ends:
///   order 2: 12 (1/6 - c_3) ((y_n - y_{n+1}) + h/2 (F_n + F_{n+1})),  order 1: (1/2 - c_2) h (F_{n+1} - F_n)
/// with c_k the Taylor coefficients of the scheme's own stability polynomial.
double Stabilised::estimate_error(const Step& step, const StateVector& y, const StateVector& next) {
  const double h = step.h();
  (*rhs_)(step.ends.front(), next, next_derivative_);
  const auto &f = derivative_, &f_next = next_derivative_;
  if (family_.order == 1) {
    const double factor = (0.5 - taylor_coefficient(scheme_, 2)) * h;
    return norm_.of([&](std::size_t i) { return factor * (f_next[i] - f[i]); });
  }
  const double factor = 12 * (1.0 / 6.0 - taylor_coefficient(scheme_, 3));
  return norm_.of([&](std::size_t i) { return factor * (y[i] - next[i] + h / 2 * (f[i] + f_next[i])); });
}

void Stabilised::accept(const Step& step, std::span<const double> state) {
  const bool is_known = fixed_step_ == 0 && !scheme_.finish;
  const bool is_used = fixed_step_ == 0 || scheme_.uses_first_derivative;
  if (!is_known && is_used) (*rhs_)(step.ends.front(), state, next_derivative_);
  if (is_used) std::swap(derivative_, next_derivative_);
}

void Stabilised::add_counts(Statistics& statistics) const {
  statistics.max_stages = std::max(statistics.max_stages, most_stages_);
}

}  // namespace superstep
