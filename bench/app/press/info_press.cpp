/// superstep info: a press with moving particles, without moving them.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "bench/app/press/press_commands.hpp"
#include "bench/measure/run_limits.hpp"
#include "bench/press/press_forecast.hpp"
#include "dynamics/heat.hpp"
#include "dynamics/volume_fraction.hpp"
#include "results/text/json_numbers.hpp"
#include "results/text/json_object.hpp"

namespace superstep {
namespace {

struct PressFacts {
  double volume = 0, mass = 0;  ///< m3, kg
  double fraction_start = 0;    ///< of the whole box
  double fraction_pressed = 0;  ///< when every particle lies below the lowest wall
  // The fastest there is among pairs of two like each particle, and among particles.
  double joule_rate = 0;       ///< K/s of a particle that carries the largest current; 0 = none
  double contact_time = 0;     ///< m C/(kappa A/d) of a pair at 10 % overlap [s]; 0 = nothing conducts
  double motion_time = 0;      ///< sqrt(m/k) of a pair at 10 % overlap, cold [s]; 0 = nothing repels
  double largest_current = 0;  ///< A
  PressForecast forecast;
};

/// What particle i and a pair of two like it do to the fastest exchange of heat.
void add_heat_of(const Press& one, std::size_t i, PressFacts& facts) {
  const auto& particles = one.particles;
  const auto& model = one.model;
  constexpr double strain = 0.1;
  const double r = particles.radius[i], distance = 2 * r * (1 - strain);
  const double capacity = dynamics::heat_capacity(model.thermal, particles, i);
  const double conductivity = dynamics::value_of(particles.conductivity, i, model.thermal.conductivity);
  if (conductivity > 0) {
    const double time = capacity * distance / (conductivity * dynamics::pair_area(distance, r, r));
    facts.contact_time = facts.contact_time > 0 ? std::min(facts.contact_time, time) : time;
  }
  const double current = facts.largest_current;
  facts.joule_rate = std::max(
      facts.joule_rate,
      model.electric.absorption * current * current * 4.0 / 3.0 * std::numbers::pi * r * r * r /
          dynamics::value_of(particles.electric_conductivity, i, model.electric.conductivity) / capacity);
}

PressFacts facts_of(const Press& one) {
  PressFacts facts;
  const auto& particles = one.particles;
  const auto& model = one.model;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double r = particles.radius[i];
    facts.volume += 4.0 / 3.0 * std::numbers::pi * r * r * r;
    facts.mass += particles.mass[i];
  }
  const Vec3 size = model.box.max - model.box.min;
  facts.fraction_start = facts.volume / (size.x * size.y * size.z);
  facts.fraction_pressed =
      facts.volume / (size.x * size.y * (model.schedule.lowest_wall() - model.box.min.z));

  if (model.electric.model == dynamics::CurrentModel::averaging)
    for (const auto& phase : model.schedule.phases())
      for (const auto& current : {phase.lower, phase.upper})
        facts.largest_current = std::max(facts.largest_current, std::abs(current.value_or(0.0)));
  for (std::size_t i = 0; i < particles.size(); ++i) add_heat_of(one, i, facts);
  facts.motion_time = pair_oscillation(one);
  facts.forecast = forecast_press(one);
  return facts;
}

std::string electrodes_text(const dynamics::Phase& phase, const char* unit) {
  std::string text;
  if (phase.lower) text += fmt::format("lower {:.4g} {}", *phase.lower, unit);
  if (phase.upper) text += fmt::format("{}upper {:.4g} {}", text.empty() ? "" : ", ", *phase.upper, unit);
  return text.empty() ? "off" : text;
}

const char* unit_of(const Press& one) {
  return one.model.electric.model == dynamics::CurrentModel::potential ? "V" : "A";
}

/// About how long a run would take; what takes over an hour is worth a warning.
std::string forecast_words(const PressForecast& forecast) {
  constexpr double hour = 3600;  // s
  const std::string time = duration_text(std::max(1.0, forecast.cpu));
  if (forecast.cpu <= hour) return time + " of CPU time";
  return time + " of CPU time: run --time-limit stops it with a checkpoint, and run --restart goes on";
}

std::string info_text(const Press& one, const PressFacts& facts) {
  std::string text = fmt::format("{}\n  {}\n", one.name, one.title);
  const auto line = [&](const char* what, const std::string& value) {
    text += fmt::format("  {:<34} {}\n", what, value);
  };
  line("particles", fmt::format("{}", one.particles.size()));
  line("particle volume, mass", fmt::format("{:.6g} m3, {:.6g} kg", facts.volume, facts.mass));
  line("volume fraction of the box", fmt::format("{:.4f}", facts.fraction_start));
  line("volume fraction, fully pressed", fmt::format("{:.4f}", facts.fraction_pressed));
  const auto time_of = [](double seconds, const char* formula, const char* without) {
    return seconds > 0 ? fmt::format("{:.4g} s ({} at 10 % overlap)", seconds, formula) : without;
  };
  line("oscillation of a pair", time_of(facts.motion_time, "sqrt(m/k), cold,", "never: nothing repels"));
  line("heat exchange of a pair", time_of(facts.contact_time, "m C d/(kappa A)", "never: nothing conducts"));
  if (facts.largest_current > 0)
    line("Joule heat", fmt::format("{:.4g} K/s at {:.4g} A", facts.joule_rate, facts.largest_current));
  line("temperatures taken by", one.stepping.thermal_integrator.empty()
                                    ? std::string("the phi rule inside the iteration")
                                    : one.stepping.thermal_integrator);
  line("end", fmt::format("{} s", one.t_end));
  line("steps, about",
       fmt::format("{:.2g}, of {:.2g} s in the mean", facts.forecast.steps, facts.forecast.step));
  line("a run takes about", forecast_words(facts.forecast));
  text += "  phase        from [s]   to [s]  upper wall [m]      current\n";
  for (const auto& phase : one.model.schedule.phases())
    text += fmt::format("  {:<12} {:>8.4g} {:>8.4g}  {:>7.4g} -> {:<7.4g}  {}\n", phase.name, phase.begin,
                        phase.end, phase.upper_wall_begin, phase.upper_wall,
                        electrodes_text(phase, unit_of(one)));
  for (const auto& warning : one.warnings) line("warning", warning);
  return text;
}

std::string info_json(const Press& one, const PressFacts& facts) {
  using Json = nlohmann::ordered_json;
  Json phases = Json::array();
  for (const auto& phase : one.model.schedule.phases())
    phases.push_back({{"name", phase.name},
                      {"begin", phase.begin},
                      {"end", phase.end},
                      {"upper_wall_begin", phase.upper_wall_begin},
                      {"upper_wall_end", phase.upper_wall},
                      {"lower", phase.lower ? Json(*phase.lower) : Json(nullptr)},
                      {"upper", phase.upper ? Json(*phase.upper) : Json(nullptr)}});
  const Json out = {
      {"schema", "superstep.press"},
      {"schema_version", 1},
      {"case", one.name},
      {"title", one.title},
      {"source", one.source},
      {"particles", one.particles.size()},
      {"volume", facts.volume},
      {"mass", facts.mass},
      {"volume_fraction_start", facts.fraction_start},
      {"volume_fraction_pressed", facts.fraction_pressed},
      {"pair_oscillation_s", positive_or_null(facts.motion_time)},
      {"pair_heat_exchange_s", positive_or_null(facts.contact_time)},
      {"joule_rate", facts.joule_rate},
      {"thermal_integrator", one.stepping.thermal_integrator},
      {"t_end", one.t_end},
      {"forecast",
       {{"steps", facts.forecast.steps}, {"step_s", facts.forecast.step}, {"cpu_s", facts.forecast.cpu}}},
      {"electrode_unit", unit_of(one)},
      {"phases", phases},
      {"warnings", one.warnings}};
  return json_text(out);
}

}  // namespace

int info_press(const InfoCommand& command, const Press& press) {
  const PressFacts facts = facts_of(press);
  print_data(command.common.json ? info_json(press, facts) : info_text(press, facts));
  return 0;
}

}  // namespace superstep
