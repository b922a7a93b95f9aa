#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/stopwatch.hpp"
#include "integrators/press/steppers.hpp"

namespace superstep::dynamics {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

std::optional<ThermalBridge> make_bridge(const std::string& spec) {
  if (spec.empty()) return std::nullopt;
  return ThermalBridge(spec);
}

}  // namespace

StaggeredStepper::StaggeredStepper(const SteppingSettings& settings, MovingNetwork& network)
    : settings_(settings),
      network_(network),
      bridge_(make_bridge(settings.thermal_integrator)),
      reduction_(network.particles().size()),
      smallest_radius_(
          *std::min_element(network.particles().radius.begin(), network.particles().radius.end())) {
  const std::size_t n = network.particles().size();
  for (auto* v : {&force_, &force_begin_, &position_, &position_before_, &velocity_}) v->resize(n);
  for (auto* v : {&rate_, &rate_begin_, &temperature_, &temperature_before_}) v->resize(n);
  position_error_.tolerance = settings.tolerance_position;
  temperature_error_.tolerance = settings.tolerance_temperature;
}

void StaggeredStepper::begin(const State& state) {
  wall_force_ = network_.forces(state.velocity, state.temperature, force_begin_, PairDetail::whole);
  if (!bridge_) network_.rates(state.temperature, rate_begin_);
  // The iteration contracts up to the limit of explicit schemes. Its bound counts the contacts of a particle
  // as if all pushed along one line; in beds the limit lies two to three times higher.
  constexpr double above_bound = 2;
  if (steady()) limit_ = above_bound * network_.explicit_limit(state.temperature);
  if (leans_back()) limit_ = std::min(steady() ? limit_ : no_limit, stable_limit(state.temperature));
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  position_rounding_ = rounding * reduction_.sum([&](std::size_t i) { return norm(state.position[i]); });
  temperature_rounding_ = rounding * reduction_.sum([&](std::size_t i) { return state.temperature[i]; });
}

/// With phi < 0.5 a step that converges may still be unstable: heat for (1 - 2 phi) h lambda > 2, motion
/// where phi adds more energy than damping takes. Half of the one; of the other, with a share d of critical
/// damping and 2/omega above the explicit limit, h <= 2 d/((1 - 2 phi) omega). Undamped motion gains energy
/// at any step: a part of critical damping then says how much of it.
double StaggeredStepper::stable_limit(std::span<const double> temperature) {
  const double lean = 1 - 2 * settings_.phi;
  const Model& model = network_.model();
  constexpr double least = 0.1;
  const double damping = std::max(least, std::min(model.contact.damping, model.wall.damping));
  const double motion = std::min(1.0, damping / lean) * network_.explicit_limit(temperature);
  return bridge_ ? motion : std::min(motion, 0.5 / lean * network_.heat_limit());
}

void StaggeredStepper::predict(const State& state, double h) {
  std::copy(force_begin_.begin(), force_begin_.end(), force_.begin());
  move(state, h);
  for (std::size_t i = 0; i < temperature_.size(); ++i)
    temperature_[i] = state.temperature[i] + (bridge_ ? 0 : h * rate_begin_[i]);
}

void StaggeredStepper::move(const State& state, double h) {
  const double phi = settings_.phi;
  const auto& mass = network_.particles().mass;
  for (std::size_t i = 0; i < position_.size(); ++i) {
    const Vec3 mean_force = phi * force_[i] + (1 - phi) * force_begin_[i];
    velocity_[i] = state.velocity[i] + (h / mass[i]) * mean_force;
    position_[i] = state.position[i] + h * (phi * velocity_[i] + (1 - phi) * state.velocity[i]);
  }
}

void StaggeredStepper::heat(const State& state, double h) {
  const double phi = settings_.phi;
  network_.rates(temperature_before_, rate_);
  for (std::size_t i = 0; i < temperature_.size(); ++i)
    temperature_[i] = state.temperature[i] + h * (phi * rate_[i] + (1 - phi) * rate_begin_[i]);
}

/// Zohdi (2014), eq. 47. False when a position is not finite, or further away than a step may take it.
bool StaggeredStepper::measure_motion(const State& state, int iteration) {
  const auto moved_by = [&](std::size_t i) { return norm(position_[i] - state.position[i]); };
  position_error_.measure(
      iteration, reduction_.sum([&](std::size_t i) { return norm(position_[i] - position_before_[i]); }),
      reduction_.sum(moved_by), position_rounding_);
  travelled_ = reduction_.max(moved_by) / smallest_radius_;
  return travelled_ <= farthest_in_a_step;
}

/// The same for the temperatures.
bool StaggeredStepper::measure_heat(const State& state, int iteration) {
  const double change =
      reduction_.sum([&](std::size_t i) { return std::abs(temperature_[i] - temperature_before_[i]); });
  temperature_error_.measure(iteration, change, reduction_.sum([&](std::size_t i) {
    return std::abs(temperature_[i] - state.temperature[i]);
  }),
                             temperature_rounding_);
  return std::isfinite(change);
}

double StaggeredStepper::factor(int iteration, double unknown) const {
  // The work for a stretch of time, iterations over step, is least at p K = ln(1/TOL): four iterations for
  // the usual tolerance and p = 2. Aiming there leaves room to converge where the next step is harder than
  // this one.
  const int wanted = steady() ? std::max(2, settings_.iterations / 2) : settings_.iterations;
  return std::min(position_error_.factor(iteration, wanted, settings_.power, unknown),
                  temperature_error_.factor(iteration, wanted, settings_.power, unknown));
}

/// How much shorter a step must be whose trial went too far; NaN went further than any number.
double StaggeredStepper::shortened() const {
  return travelled_ > farthest_in_a_step ? farthest_in_a_step / travelled_ : settings_.bounds.shrink;
}

Attempt StaggeredStepper::failed(const State& state, int iteration, double wanted) const {
  Attempt attempt;
  attempt.iterations = iteration;
  attempt.factor = wanted;
  blame(state, attempt);
  return attempt;
}

/// The particle that changed most in the last iteration, or the first that is not finite.
void StaggeredStepper::blame(const State& state, Attempt& attempt) const {
  const bool by_heat = temperature_error_.violation() > position_error_.violation();
  double worst = -1;
  for (std::size_t i = 0; i < position_.size(); ++i) {
    const double change = by_heat ? std::abs(temperature_[i] - temperature_before_[i])
                                  : norm(position_[i] - position_before_[i]);
    const bool finite = std::isfinite(norm(position_[i]) + norm(force_[i]) + temperature_[i]);
    if (finite && !(change > worst)) continue;
    worst = change;
    attempt.culprit = static_cast<std::int32_t>(i);
    attempt.why = !finite ? "has a force or temperature that is not finite"
                          : fmt::format("still changes by {:.3g} {} in iteration {}, of {:.3g} in the step",
                                        change, by_heat ? "K" : "m", attempt.iterations,
                                        by_heat ? std::abs(temperature_[i] - state.temperature[i])
                                                : norm(position_[i] - state.position[i]));
    if (!finite) return;
  }
}

void StaggeredStepper::place(const State& state, const Phase& phase, double h) {
  network_.place(position_, temperature_, phase, std::min(state.time + h, phase.end), {h, settings_.phi});
}

/// One iteration from the trial state at hand, whose contacts are placed: motion first, then temperatures.
bool StaggeredStepper::iterate(const State& state, const Phase& phase, double h, int iteration) {
  (void)network_.forces(velocity_, temperature_, force_);
  std::swap(position_, position_before_);
  move(state, h);
  if (!measure_motion(state, iteration)) return false;
  place(state, phase, h);
  if (bridge_) return true;
  std::swap(temperature_, temperature_before_);
  heat(state, h);
  return measure_heat(state, iteration);
}

Attempt StaggeredStepper::attempt(State& state, const Phase& phase, double h) {
  position_error_.begin();
  temperature_error_.begin();
  predict(state, h);
  std::copy(state.position.begin(), state.position.end(), position_before_.begin());
  if (!measure_motion(state, 0)) return failed(state, 0, shortened());
  place(state, phase, h);
  position_error_.begin();
  for (int k = 1; k <= settings_.iterations; ++k) {
    const double before = std::max(position_error_.violation(), temperature_error_.violation());
    if (!iterate(state, phase, h, k)) return failed(state, k, shortened());
    const double now = std::max(position_error_.violation(), temperature_error_.violation());
    if (now > 1 && steady() && k >= 3 && now > before) return failed(state, k, factor(k, 1));  // diverges
    if (now > 1) continue;
    Attempt attempt;
    attempt.iterations = k;
    if (leans_back()) {  // it may have begun in free flight and end in a contact that is too stiff for it
      (void)network_.forces(velocity_, temperature_, force_, PairDetail::whole);
      const double longest = stable_limit(temperature_);
      attempt.factor = longest / h;
      if (h > stiffening * longest) return attempt;
    }
    attempt.converged = true;
    // No rate can be told from one iteration: the step was easy and may grow. As far as its bounds allow, it
    // would soon be too long and be made again.
    constexpr double cautious = 1.25;
    attempt.factor =
        factor(k, steady() ? std::min(cautious, settings_.bounds.growth) : settings_.bounds.growth);
    if (bridge_) attempt.failure = bridge_heat(state, h);
    if (!attempt.failure.ok()) return attempt;
    std::swap(state.position, position_);
    std::swap(state.velocity, velocity_);
    std::swap(state.temperature, temperature_);
    return attempt;
  }
  return failed(state, settings_.iterations, factor(settings_.iterations, 1));
}

Outcome StaggeredStepper::bridge_heat(const State& state, double h) {
  const double before = process_cpu_seconds();
  std::copy(state.temperature.begin(), state.temperature.end(), temperature_.begin());
  Outcome outcome = bridge_->advance(network_, h, temperature_, stop);
  network_.times.heat += process_cpu_seconds() - before;
  return outcome;
}

std::unique_ptr<Stepper> make_stepper(const SteppingSettings& settings, MovingNetwork& network) {
  if (settings.scheme == SteppingSettings::Scheme::plain)
    return std::make_unique<PlainStepper>(settings, network);
  return std::make_unique<StaggeredStepper>(settings, network);
}

}  // namespace superstep::dynamics
