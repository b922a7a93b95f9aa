#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "integrators/press/steppers.hpp"

namespace superstep::dynamics {

PlainStepper::PlainStepper(const SteppingSettings& settings, MovingNetwork& network)
    : fraction_(settings.fraction),
      smallest_radius_(
          *std::min_element(network.particles().radius.begin(), network.particles().radius.end())),
      network_(network) {
  if (!settings.thermal_integrator.empty()) bridge_.emplace(settings.thermal_integrator);
  const std::size_t n = network.particles().size();
  for (auto* v : {&force_, &force_end_, &position_, &velocity_}) v->resize(n);
  for (auto* v : {&rate_, &temperature_}) v->resize(n);
}

void PlainStepper::begin(const State& state) {
  if (evaluated_ == network_.instant())
    std::swap(force_, force_end_);  // the last step ended here
  else
    wall_force_end_ = network_.forces(state.velocity, state.temperature, force_, PairDetail::whole);
  evaluated_ = none;
  wall_force_ = wall_force_end_;
  limit_ = fraction_ * network_.explicit_limit(state.temperature);
  if (bridge_) return;
  network_.rates(state.temperature, rate_);
  limit_ = std::min(limit_, fraction_ * network_.heat_limit());
}

/// A step from free flight into a contact begins without a limit: it keeps to that of its end, too, but for
/// what contacts that stand grow stiffer in a step. Returns the factor that a step of h must be shortened by
/// for that.
double PlainStepper::shortened(double h) {
  wall_force_end_ = network_.forces(velocity_, temperature_, force_end_, PairDetail::whole);
  evaluated_ = network_.instant();
  const double longest = fraction_ * network_.explicit_limit(temperature_);
  return h > stiffening * longest ? longest / h : 1.0;
}

Attempt PlainStepper::attempt(State& state, const Phase& phase, double h) {
  Attempt attempt;
  const auto& mass = network_.particles().mass;
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (std::isfinite(norm(force_[i]) + (bridge_ ? 0 : rate_[i]))) continue;
    attempt.culprit = static_cast<std::int32_t>(i);
    attempt.why = "has a force or temperature that is not finite";
    attempt.factor = 0.1;
    return attempt;
  }
  for (std::size_t i = 0; i < state.size(); ++i) {
    velocity_[i] = state.velocity[i] + (h / mass[i]) * force_[i];
    position_[i] = state.position[i] + h * velocity_[i];
    temperature_[i] = state.temperature[i] + (bridge_ ? 0 : h * rate_[i]);
  }
  for (std::size_t i = 0; i < state.size(); ++i) {
    const double moved = norm(position_[i] - state.position[i]) / smallest_radius_;
    if (moved <= farthest_in_a_step) continue;
    attempt.culprit = static_cast<std::int32_t>(i);
    attempt.why = fmt::format("would go {:.3g} of the smallest radius in one step", moved);
    attempt.factor = farthest_in_a_step / moved;
    return attempt;
  }
  // Necks grow like the temperatures: with the rate that the step begins with.
  network_.place(position_, state.temperature, phase, std::min(state.time + h, phase.end), {h, 0});
  if (bridge_) attempt.failure = bridge_->advance(network_, h, temperature_, stop);
  if (!attempt.failure.ok()) return attempt;
  attempt.factor = shortened(h);
  if (attempt.factor < 1) return attempt;
  attempt.factor = std::numeric_limits<double>::infinity();  // as far as the limits let it grow
  std::swap(state.position, position_);
  std::swap(state.velocity, velocity_);
  std::swap(state.temperature, temperature_);
  attempt.converged = true;
  attempt.iterations = 1;
  return attempt;
}

}  // namespace superstep::dynamics
