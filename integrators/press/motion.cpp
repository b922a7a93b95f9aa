#include "integrators/press/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "dynamics/volume_fraction.hpp"

namespace superstep::dynamics {
namespace {

constexpr double rounding = 1e-9;  // relative slack when a step is fitted to the time that remains

/// The step that `wanted` becomes when `remaining` is left: no sliver of a step stays behind.
double fitted(double wanted, double remaining) {
  if (remaining > 2 * wanted * (1 + rounding)) return wanted;
  return remaining > wanted * (1 + rounding) ? remaining / 2 : remaining;
}

}  // namespace

Motion::Motion(const Model& model, const Particles& particles, const SteppingSettings& settings)
    : model_(model), particles_(particles), settings_(settings), network_(model, particles) {
  if (particles.size() == 0) throw InputError("there are no particles; give at least one");
  check_settings(settings);
  stepper_ = make_stepper(settings, network_);
  steady_ = settings.control == SteppingSettings::Control::steady &&
            settings.scheme == SteppingSettings::Scheme::staggered;
  locates_ = steady_ && has_switches(model);
  smallest_radius_ = *std::min_element(particles.radius.begin(), particles.radius.end());
}

void Motion::start(State state) {
  state_ = std::move(state);
  state_.electric.resize(state_.size(), 0.0);
  history_.clear();
  step_ = settings_.first_step;
  rejected_ = iterations_ = 0;
  const Phase& phase = model_.schedule.at(state_.time);
  network_.resume(state_, phase);
  network_.settle(state_, phase);
  stepper_->begin(state_);
  powers_ = powers_of(network_, state_.velocity, state_.temperature);
  record(phase, 0, 0, 0);
}

void Motion::resume(State state, double next_step, std::vector<HistoryRow> history) {
  state_ = std::move(state);
  history_ = std::move(history);
  step_ = next_step;
  rejected_ = iterations_ = 0;
  for (const auto& row : history_) {
    rejected_ += static_cast<std::uint64_t>(row.rejections);
    iterations_ += static_cast<std::uint64_t>(row.iterations);
  }
  network_.resume(state_, model_.schedule.at(state_.time));
  stepper_->begin(state_);
  powers_ = powers_of(network_, state_.velocity, state_.temperature);
}

Outcome Motion::advance(double t_out) {
  if (Outcome outcome = check(); !outcome.ok()) return outcome;
  while (state_.time < t_out) {
    if (Outcome outcome = take_step(t_out); !outcome.ok()) return outcome;
    if (state_.time < t_out && stop && *stop) return stopped();  // what was asked for comes first
  }
  return {};
}

Outcome Motion::stopped() const {
  return {Status::interrupted, fmt::format("stopped at t = {:.6g} s", state_.time)};
}

Outcome Motion::take_step(double t_out) {
  const Phase& phase = model_.schedule.at(state_.time);
  // The last phase goes on for ever: its wall stays where the schedule left it.
  const double end = state_.time < phase.end ? std::min(t_out, phase.end) : t_out;
  const bool flows = model_.electric.model != CurrentModel::none;
  if (locates_ || flows) before_ = state_;
  const double step_at_begin = step_;
  stepper_->stop = stop;
  const double longest = std::min({settings_.largest_step, stepper_->limit(), travel_limit()});
  if (longest < settings_.smallest_step && longest < end - state_.time) return held_down(longest);
  for (std::int64_t rejections = 0;; ++rejections) {
    const double remaining = end - state_.time;
    double h = fitted(std::min(step_, longest), remaining);
    bool landed = false;
    const Attempt attempt = land(phase, h, landed);
    const bool to_end = h == remaining;
    if (attempt.failure.status == Status::interrupted) {
      step_ = step_at_begin;  // what goes on from here tries what this step tried
      return stopped();
    }
    if (!attempt.failure.ok()) return attempt.failure;
    if (attempt.converged) {
      state_.time = to_end ? end : state_.time + h;
      // A step that had to be restarted found its size the hard way: do not grow it at once.
      const double factor = settings_.bounds.after_success(attempt.factor);
      const double wanted = h * (rejections > 0 ? std::min(factor, 1.0) : factor);
      step_ = std::min(settings_.largest_step, h < step_ * (1 - rounding) ? std::max(step_, wanted) : wanted);
      const std::size_t rows = history_.size();
      try {
        accept(phase, h, attempt, rejections, landed);
      } catch (const NumericalError& error) {  // of the current
        return undone(phase, rows, error.what());
      }
      return check();
    }
    // A restart begins from the same state, whose current is solved already (Algorithm 1, step 7b).
    ++rejected_;
    step_ = h * settings_.bounds.after_failure(attempt.factor);
    if (step_ < settings_.smallest_step || state_.time + step_ <= state_.time)
      return collapsed(step_, attempt);
  }
}

/// Back to where the step began, whose current is known.
Outcome Motion::undone(const Phase& phase, std::size_t rows, const std::string& why) {
  history_.resize(rows);
  state_ = before_;
  network_.resume(state_, phase);
  stepper_->begin(state_);
  powers_ = powers_of(network_, state_.velocity, state_.temperature);
  return {Status::failed, fmt::format("at t = {:.6g} s: {}", state_.time, why)};
}

/// Step in which nobody goes too far at the speed of now [s]; what forces add, the steppers watch.
double Motion::travel_limit() const {
  constexpr double margin = 0.8;  // for what they add
  double fastest = 0;             // smallest radii a second
  for (std::size_t i = 0; i < state_.size(); ++i)
    fastest = std::max(fastest, norm(state_.velocity[i]) / smallest_radius_);
  return fastest > 0 ? margin * farthest_in_a_step / fastest : std::numeric_limits<double>::infinity();
}

/// A step of h [s], or to just behind the first jump in it: `h` becomes shorter then. More than a few jumps
/// in one step are not worth a step each, nor are those of somebody who hovers at a wall or a threshold: they
/// happen at the end of their step.
Attempt Motion::land(const Phase& phase, double& h, bool& landed) {
  constexpr std::size_t few = 4;
  constexpr int trials = 8;
  constexpr double close = 1e-5;  // of a step: a jump that is late by that
  if (!locates_ || landings_lately(h) >= few) return stepper_->attempt(state_, phase, h);
  const double whole = h;
  double beyond = 1e-2 * close * whole;  // behind where it is expected: what is there has happened
  for (int trial = 0;; ++trial) {
    Attempt attempt = stepper_->attempt(state_, phase, h);
    if (!attempt.failure.ok() || !attempt.converged) return attempt;
    const auto switches = find_switches(network_, before_, state_, phase, h);
    landed = !switches.empty() && (1 - switches.front().part) * h <= close * whole;
    const bool many = trial == 0 && switches.size() > few, none = trial == 0 && switches.empty();
    if (landed || many || none || trial == trials) return attempt;
    if (switches.empty()) beyond *= 10;  // stopped short of it
    const double next = switches.empty() ? h + beyond : switches.front().part * h + beyond;
    h = std::clamp(next, std::min(std::max(close * whole, settings_.smallest_step), whole), whole);
    state_ = before_;
  }
}

/// Landings of the last eight steps' time.
std::size_t Motion::landings_lately(double h) const {
  constexpr double steps = 8;
  std::size_t count = 0;
  for (auto row = history_.rbegin(); row != history_.rend() && row->time > state_.time - steps * h; ++row)
    count += row->landed ? 1 : 0;
  return count;
}

/// The heat of the current is that of the step's begin all through the step; half of its change makes it the
/// mean, so that temperatures are of order 2 with currents that change. What jumps at the end was not there
/// before. True where any temperature changed.
bool Motion::correct_heat(double h, double& heat_added) {
  const auto heat = network_.current().heat();
  const auto carrying = network_.current().carrying();
  const auto held = network_.held();
  bool changed = false;
  for (std::size_t i = 0; i < heat.size(); ++i) {
    if (held[i] >= 0 || carrying[i] != carrying_begin_[i] || heat[i] == heat_begin_[i]) continue;
    const double more = settings_.phi * h * (heat[i] - heat_begin_[i]);
    state_.temperature[i] += more / heat_capacity(model_.thermal, particles_, i);
    heat_added += more;
    changed = true;
  }
  return changed;
}

void Motion::accept(const Phase& phase, double h, const Attempt& attempt, std::int64_t rejections,
                    bool landed) {
  iterations_ += static_cast<std::uint64_t>(attempt.iterations);
  if (observe_step) observe_step(network_, h);
  connected_ = network_.current().connected();
  const bool corrects = steady_ && !landed && model_.electric.model != CurrentModel::none;
  if (corrects) {
    const auto heat = network_.current().heat();
    const auto carrying = network_.current().carrying();
    heat_begin_.assign(heat.begin(), heat.end());
    carrying_begin_.assign(carrying.begin(), carrying.end());
  }
  const double content = heat_content(network_, state_.temperature);
  network_.settle(state_, phase);
  const double held_back = content - heat_content(network_, state_.temperature);
  double corrected = 0;
  if (corrects && correct_heat(h, corrected)) network_.refresh(state_, phase);
  stepper_->begin(state_);
  const HistoryRow before = history_.empty() ? HistoryRow{} : history_.back();
  const Powers end = powers_of(network_, state_.velocity, state_.temperature);
  record(phase, h, attempt.iterations, rejections);
  HistoryRow& row = history_.back();
  row.landed = landed ? 1 : 0;
  const bool staggered = settings_.scheme == SteppingSettings::Scheme::staggered;
  add_energies(before, powers_, end, h, staggered ? settings_.phi : 0, row);
  // A bridge follows the temperatures through the step: its flux at the two ends does not tell what was lost.
  if (stepper_->bridge())
    row.heat_lost = before.heat_lost + h * powers_.joule + before.heat_content - content;
  row.joule_heat += corrected;
  row.heat_lost += held_back;
  powers_ = end;
  if (const Phase& next = model_.schedule.at(state_.time); &next != &phase) {
    network_.place(state_.position, state_.temperature, next, state_.time);
    history_.back().heat_lost += heat_content(network_, state_.temperature);
    network_.settle(state_, next);
    record_temperatures(history_.back());
    history_.back().heat_lost -= history_.back().heat_content;
    stepper_->begin(state_);
    powers_ = powers_of(network_, state_.velocity, state_.temperature);
  }
  if (after_step) after_step();
}

Outcome Motion::check() const {
  for (const auto& contact : network_.walls()) {
    if (!(contact.distance < 0)) continue;
    const Vec3& at = state_.position[static_cast<std::size_t>(contact.particle)];
    return {
        Status::failed,
        fmt::format("particle {} at ({:.4g}, {:.4g}, {:.4g}) m escapes through the {} wall at t = {:.6g} s; "
                    "make the walls stiffer, the press slower or the step smaller",
                    particles_.id[static_cast<std::size_t>(contact.particle)], at.x, at.y, at.z,
                    wall_name(contact.wall), state_.time)};
  }
  return {};
}

/// Of limits that no attempt has to find.
Outcome Motion::held_down(double longest) const {
  const auto fastest = std::ranges::max_element(state_.velocity, {},
                                                [](const Vec3& velocity) { return dot(velocity, velocity); });
  const auto k = static_cast<std::size_t>(fastest - state_.velocity.begin());
  const std::string why =
      longest == travel_limit()
          ? fmt::format(
                "particle {} moves at {:.4g} m/s, beside a smallest radius of {:.3g} m; check velocities "
                "and their unit",
                particles_.id[k], norm(*fastest), smallest_radius_)
          : std::string(
                "contacts, friction or drag are that stiff; soften them, or check radii and densities");
  return {
      Status::failed,
      fmt::format("a step may be no longer than {:.3g} s, below smallest_step = {:.3g} s, at t = {:.6g} s: "
                  "{}; or allow shorter ones",
                  longest, settings_.smallest_step, state_.time, why)};
}

Outcome Motion::collapsed(double h, const Attempt& attempt) const {
  std::string who = "no single particle stands out";
  if (attempt.culprit >= 0) {
    const auto k = static_cast<std::size_t>(attempt.culprit);
    const Vec3& at = state_.position[k];
    who = fmt::format("particle {} at ({:.4g}, {:.4g}, {:.4g}) m, {:.4g} K {}", particles_.id[k], at.x, at.y,
                      at.z, state_.temperature[k], attempt.why);
  }
  return {Status::failed,
          fmt::format("the step shrank to {:.3g} s, below smallest_step = {:.3g} s, at t = {:.6g} s: {}; "
                      "loosen the tolerance, allow more iterations, or soften what acts on that particle",
                      h, settings_.smallest_step, state_.time, who)};
}

void Motion::record(const Phase& phase, double h, std::int64_t iterations, std::int64_t rejections) {
  HistoryRow row;
  row.time = state_.time;
  row.phase = static_cast<std::int32_t>(&phase - model_.schedule.phases().data());
  row.volume_fraction =
      volume_fraction(model_.box, model_.schedule.lowest_wall(), state_.position, particles_.radius);
  for (std::size_t i = 0; i < state_.size(); ++i)
    row.kinetic_energy += 0.5 * particles_.mass[i] * dot(state_.velocity[i], state_.velocity[i]);
  record_temperatures(row);
  row.wall_force = stepper_->wall_force();
  row.bonds = static_cast<std::int64_t>(state_.bonds.size());
  row.contacts = static_cast<std::int64_t>(network_.contacts().touching());
  row.step = h;
  row.iterations = iterations;
  row.rejections = rejections;
  history_.push_back(row);
}

/// All that a row says of the temperatures of now.
void Motion::record_temperatures(HistoryRow& row) const {
  row.mean_temperature = 0;
  row.max_temperature = state_.temperature.front();
  for (const double temperature : state_.temperature) {
    row.mean_temperature += temperature;
    row.max_temperature = std::max(row.max_temperature, temperature);
  }
  row.mean_temperature /= static_cast<double>(state_.size());
  row.heat_content = heat_content(network_, state_.temperature);
}

}  // namespace superstep::dynamics
