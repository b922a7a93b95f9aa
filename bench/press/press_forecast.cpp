#include "bench/press/press_forecast.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/laws/damping.hpp"
#include "integrators/press/motion.hpp"

namespace superstep {
namespace {

using dynamics::SteppingSettings;

constexpr double no_limit = std::numeric_limits<double>::infinity();

bool is_plain(const Press& press) {
  return press.stepping.scheme == SteppingSettings::Scheme::plain;
}

/// What the scheme allows at the start [s]; infinite where the particles are still falling.
double limit_of_bed(const Press& press) {
  dynamics::State state = press.state;
  state.electric.resize(state.size(), 0.0);
  dynamics::MovingNetwork network(press.model, press.particles);
  network.resume(state, press.model.schedule.at(state.time));
  if (network.contacts().touching() < state.size()) return no_limit;
  const auto stepper = dynamics::make_stepper(press.stepping, network);
  stepper->begin(state);
  return stepper->limit();
}

/// The same without a bed [s].
double limit_of_pairs(const Press& press) {
  constexpr double part = 1.0 / 6;  // of an oscillation
  const double oscillation = pair_oscillation(press);
  if (!(oscillation > 0)) return no_limit;
  // The plain scheme takes its fraction of the bound of which the staggered one takes twice.
  return part * oscillation * (is_plain(press) ? press.stepping.fraction / 2 : 1);
}

}  // namespace

double pair_oscillation(const Press& press) {
  constexpr double strain = 0.1;
  const auto& law = press.model.contact;
  double shortest = no_limit;
  for (std::size_t i = 0; i < press.particles.size(); ++i) {
    const double r = press.particles.radius[i], distance = 2 * r * (1 - strain);
    const double force = dynamics::value_of(press.particles.hardness, i, 1) *
                         dynamics::contact_force(law, -strain, dynamics::pair_area(distance, r, r),
                                                 press.state.temperature[i]);
    if (!(force > 0)) continue;
    shortest = std::min(shortest, std::sqrt(press.particles.mass[i] /
                                            dynamics::contact_slope(force, law.exponent, strain, 2 * r)));
  }
  return std::isfinite(shortest) ? shortest : 0;
}

PressForecast forecast_press(const Press& press) {
  const double cost = is_plain(press) ? 3e-7 : 1e-6;  // s of CPU a particle and step
  const double bed = limit_of_bed(press);
  PressForecast out;
  const double time = press.t_end - press.state.time;
  out.step = std::min({press.stepping.largest_step, std::isfinite(bed) ? bed : limit_of_pairs(press), time});
  out.steps = std::ceil(time / out.step);
  out.cpu = out.steps * static_cast<double>(press.particles.size()) * cost;
  return out;
}

}  // namespace superstep
