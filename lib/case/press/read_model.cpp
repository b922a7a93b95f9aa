#include "case/press/read_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "case/inputs/workable_times.hpp"
#include "case/press/read_materials.hpp"
#include "case/press/read_particles.hpp"
#include "case/press/read_values.hpp"
#include "core/error.hpp"
#include "dynamics/contacts/bond_registry.hpp"

namespace superstep::dynamics {
namespace {

ContactLaw read_contact(TomlTable table) {
  ContactLaw law;
  law.stiffness = required_from(table, "stiffness", 0, "N/m2");
  law.exponent = number_from(table, "exponent", 1, law.exponent, "-");
  law.softening.temperature = positive_or(table, "softening_temperature", law.softening.temperature, "K");
  law.softening.floor = number_from(table, "stiffness_floor", 0, 0, "N/m2");
  law.friction = number_from(table, "friction", 0, 0, "-");
  law.friction_speed = positive_or(table, "friction_speed", law.friction_speed, "m/s");
  law.damping = number_from(table, "damping", 0, 0, "-");
  table.finish();  // what depends on a misspelt key would be said of another one
  return law;
}

NeckGrowth read_growth(TomlTable table) {
  NeckGrowth law;
  law.mechanism = word_from(table, "mechanism", {"frenkel", "coble"}, "frenkel") == "coble"
                      ? NeckGrowth::Mechanism::coble
                      : NeckGrowth::Mechanism::frenkel;
  law.rate = required_from(table, "rate", 0, "1/s");
  law.activation = number_from(table, "activation_energy", 0, 0, "J/mol");
  law.reference = positive_or(table, "reference_temperature", law.reference, "K");
  law.sintering_stress = positive_or(table, "sintering_stress", law.sintering_stress, "Pa");
  table.finish();
  return law;
}

BondRule read_rule(TomlTable& table) {
  std::vector<std::string> names;
  for (const auto& kind : bond_kinds()) names.emplace_back(kind.name);
  const std::string name = word_from(table, "rule", names, "overlap");
  return bond_kinds()[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())]
      .rule;
}

BondLaw read_bond(TomlTable& table) {
  BondLaw law;
  law.rule = read_rule(table);
  const bool neck = law.rule == BondRule::rest_length;
  const auto only = [&](std::initializer_list<const char*> keys, bool allowed, const char* why) {
    for (const char* key : keys)
      if (const auto value = table.find(key); value && !allowed) value->reject(why);
  };
  only({"unloading", "damping", "growth"}, neck,
       "bonds of this rule have no neck; remove it, or take rule = \"rest-length\"");
  only({"exponent"}, !neck, "a neck pulls linearly; remove it, or take another rule");
  only({"rupture"}, law.rule != BondRule::overlap,
       "a bond that acts in overlap only cannot rupture; remove it, or take rule = \"tension\"");
  law.stiffness = required_from(table, "stiffness", 0, "N/m2");
  law.exponent = number_from(table, "exponent", 1, law.exponent, "-");
  law.threshold = table.positive("threshold", "-");
  law.softening.temperature = positive_or(table, "softening_temperature", law.softening.temperature, "K");
  law.softening.floor = number_from(table, "stiffness_floor", 0, 0, "N/m2");
  constexpr double usual_rupture = 0.2;  // of a neck, from the length that it has grown at
  law.rupture = positive_or(table, "rupture", neck ? usual_rupture : law.rupture, "-");
  if (!neck) return law;
  law.unloading = positive_or(table, "unloading", law.unloading, "-");
  law.damping = number_from(table, "damping", 0, 0, "-");
  law.growth = read_growth(table_from(table, "growth", "how the neck grows: mechanism and rate"));
  if (!(law.unloading <= 0.5 * law.rupture))
    table.require(table.find("unloading") ? "unloading" : "rupture", "")
        .reject(fmt::format("the unloading strain {} must be at most half the rupture strain {}",
                            law.unloading, law.rupture));
  return law;
}

/// What the powers of the overlap add to the pull over the push, at the overlap where that is most: at the
/// threshold, where a bond forms, or at 1.
double ratio_of_powers(const BondLaw& bond, const ContactLaw& contact) {
  return std::max(1.0, std::pow(std::min(bond.threshold, 1.0), bond.exponent - contact.exponent));
}

/// Largest pull of a bond over the push of a contact of this hardness, at any temperature and any overlap
/// from the threshold on. Both stiffnesses fall in straight lines to their floors, so that the corners, the
/// coldest and the hottest are enough, and powers of the overlap are farthest apart at its ends.
double strongest_pull(const BondLaw& bond, const ContactLaw& contact, double hardness) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const auto corner = [](double stiffness, const Softening& softening) {
    return stiffness > softening.floor ? softening.temperature * (1 - softening.floor / stiffness) : 0.0;
  };
  const auto hottest = [](double stiffness, const Softening& softening) {
    return std::isfinite(softening.temperature) ? softening.floor : std::max(stiffness, softening.floor);
  };
  const auto ratio = [&](double pull, double push) {
    return push > 0 ? pull / (hardness * push) : pull > 0 ? never : 0.0;
  };
  double largest =
      ratio(hottest(bond.stiffness, bond.softening), hottest(contact.stiffness, contact.softening));
  for (const double temperature :
       {0.0, corner(bond.stiffness, bond.softening), corner(contact.stiffness, contact.softening)})
    if (std::isfinite(temperature))
      largest = std::max(largest, ratio(softened(bond.stiffness, bond.softening, temperature),
                                        softened(contact.stiffness, contact.softening, temperature)));
  return largest * ratio_of_powers(bond, contact);
}

/// Where a bond pulls harder than the contact pushes at every overlap that it acts at, nothing stops two
/// particles on their way into each other, and the speed that they gain is without bound.
void require_bounded_attraction(TomlTable& bond, const BondLaw& law, const ContactLaw& contact,
                                std::span<const PressMaterial> materials) {
  double hardness = materials.front().hardness;
  for (const auto& material : materials) hardness = std::min(hardness, material.hardness);
  // A neck pulls to the length that it has grown at, and no further.
  if (!law.acts() || law.rule == BondRule::rest_length || strongest_pull(law, contact, hardness) < 1) return;
  const bool softens = std::isfinite(contact.softening.temperature);
  const double softest = softens ? std::min(contact.softening.floor, contact.stiffness) : contact.stiffness;
  const double powers = ratio_of_powers(law, contact);
  std::string what = softens ? "stiffness_floor of hot contacts" : "stiffness";
  if (hardness != 1) what += fmt::format(" times the smallest hardness, {},", hardness);
  if (powers > 1) what += fmt::format(" times threshold^({} - {})", contact.exponent, law.exponent);
  bond.require("stiffness", "")
      .reject(
          fmt::format("it must be below {:.10g} N/m2, the {} of [dynamics.contact], or soften with it: a "
                      "bond that pulls harder than the contact pushes draws its particles into each other",
                      hardness * softest / powers, what));
}

void read_wall_temperatures(TomlTable& table, ThermalLaw& law) {
  law.walls_conduct = boolean_or(table, "walls_conduct", true);
  const auto walls = table.require("walls", "a temperature [K], or a table with lower, upper and sides");
  if (walls.is_number()) {
    if (walls.number() < 0) walls.reject("it must be >= 0 [K]");
    law.wall_temperature.fill(walls.number());
    return;
  }
  TomlTable each = table_from(table, "walls", "");
  law.wall_temperature.fill(required_from(each, "sides", 0, "K"));
  law.wall_temperature[lower] = required_from(each, "lower", 0, "K");
  law.wall_temperature[upper] = required_from(each, "upper", 0, "K");
}

/// sigma(T, E) of eq. 50.
Saturation read_saturation(TomlTable table, CurrentModel model) {
  Saturation law;
  law.thermal = number_from(table, "thermal", 0, 0, "-");
  law.thermal_slope = number_from(table, "thermal_slope", 0, 0, "1/K");
  law.temperature = number_from(table, "temperature", 0, law.temperature, "K");
  const auto field = table.find("field");
  if (field && model != CurrentModel::potential)
    field->reject("particle currents have no field; remove it, or take model = \"potential\"");
  law.field = number_from(table, "field", 0, 0, "-");
  law.field_slope = number_from(table, "field_slope", 0, 0, "m/V");
  law.reference_field = number_from(table, "reference_field", 0, 0, "V/m");
  table.finish();
  return law;
}

ElectricLaw read_electric(TomlTable table, bool several) {
  ElectricLaw law;
  law.model = word_from(table, "model", {"averaging", "potential"}, "averaging") == "averaging"
                  ? CurrentModel::averaging
                  : CurrentModel::potential;
  const std::string solver = word_from(table, "solver", {"jacobi", "conjugate", "direct"}, "conjugate");
  law.solver = solver == "jacobi"   ? CurrentSolver::jacobi
               : solver == "direct" ? CurrentSolver::direct
                                    : CurrentSolver::conjugate;
  if (!several) law.conductivity = table.positive("conductivity", "S/m");
  if (auto saturation = table.table("saturation")) law.saturation = read_saturation(*saturation, law.model);
  const auto absorption = table.find("absorption");
  if (absorption && !(absorption->number() >= 0 && absorption->number() <= 1))
    absorption->reject("it must lie between 0 and 1");
  if (absorption) law.absorption = absorption->number();
  law.tolerance = positive_or(table, "tolerance", law.tolerance, "-");
  law.hold_temperature = boolean_or(table, "hold_temperature", true);
  return law;
}

Box read_box(TomlTable table) {
  Box box;
  box.min = point_from(table.require("min", "it is the corner [x, y, z] in m"));
  const auto corner = table.require("max", "it is the corner [x, y, z] in m; z = start of the upper wall");
  box.max = point_from(corner);
  const Vec3 size = box.max - box.min;
  if (!(size.x > 0 && size.y > 0 && size.z > 0)) corner.reject("every coordinate must exceed that of min");
  return box;
}

void read_electrodes(TomlTable& table, const ElectricLaw& law, Phase& phase) {
  const bool averaging = law.model == CurrentModel::averaging;
  for (const auto& [key, fits, other] :
       {std::tuple{"current", averaging, "[electric] with model = \"averaging\""},
        std::tuple{"potential", law.model == CurrentModel::potential,
                   "[electric] with model = \"potential\""}}) {
    const auto value = table.find(key);
    if (!value) continue;
    if (!fits) value->reject(fmt::format("it needs {}", other));
    TomlTable walls = *table.table(key);
    phase.lower = walls.number("lower");
    phase.upper = walls.number("upper");
  }
}

Schedule read_phases(TomlTable& dynamics, const Model& model, double t_end) {
  const auto list = dynamics.require("phases", "one table [[dynamics.phases]] with name and until for each");
  std::vector<Phase> phases;
  std::vector<std::string> named_at;
  double time = 0, height = model.box.max.z;
  for (const auto& entry : list.array()) {
    TomlTable table = entry.table();
    Phase phase;
    const auto name = table.require("name", "e.g. \"pour\"");
    phase.name = name.string();
    for (std::size_t k = 0; k < phases.size(); ++k)
      if (phases[k].name == phase.name)
        name.reject(fmt::format("{} is the same, and results tell phases by their names; give each its own",
                                named_at[k]));
    named_at.push_back(name.where());
    const auto until = table.require("until", "time at which the phase ends [s]");
    phase.begin = time;
    phase.end = until.number();
    if (!(phase.end > time))
      until.reject(fmt::format("it must be later than the phase begins, at {} s", time));
    if (const auto rule = unworkable_time("the length of the phase,", phase.end - time); !rule.empty())
      until.reject(rule);
    phase.upper_wall_begin = phase.upper_wall = height;
    if (const auto wall = table.find("upper_wall")) {
      phase.upper_wall = wall->number();
      if (!(phase.upper_wall > model.box.min.z))
        wall->reject(
            fmt::format("the walls would cross: it must stay above the lower wall at {} m", model.box.min.z));
    }
    read_electrodes(table, model.electric, phase);
    table.finish();
    time = phase.end;
    height = phase.upper_wall;
    phases.push_back(phase);
  }
  if (time < t_end)
    list.reject(
        fmt::format("the last phase ends at {} s, before t_end = {} s; let it last longer", time, t_end));
  return Schedule(std::move(phases));
}

double smallest_radius(const Particles& particles) {
  return *std::min_element(particles.radius.begin(), particles.radius.end());
}

}  // namespace

ModelInput read_model(TomlTable& root, double t_end, std::optional<std::uint64_t> seed,
                      const Placed& placed) {
  ModelInput input;
  Model& model = input.model;
  const auto materials = read_press_materials(root, root.find("electric").has_value());
  const bool several = !materials.front().name.empty();
  if (several)
    for (const auto& material : materials) model.material_names.push_back(material.name);

  TomlTable thermal = table_from(root, "thermal", "moving particles need their temperatures");
  if (!several) {
    model.thermal.conductivity = required_from(thermal, "conductivity", 0, "W/(m K)");
    model.thermal.specific_heat = thermal.positive("specific_heat", "J/(kg K)");
  }
  const double initial = required_from(thermal, "initial", 0, "K");
  read_wall_temperatures(thermal, model.thermal);
  if (root.find("electric")) model.electric = read_electric(*root.table("electric"), several);

  TomlTable dynamics = table_from(root, "dynamics", "it holds the laws of motion");
  model.gravity = number_from(dynamics, "gravity", 0, model.gravity, "m/s2");
  model.drag.coefficient = number_from(dynamics, "drag", 0, 0, "kg/(m s)");
  if (const auto medium = dynamics.find("medium_velocity")) model.drag.medium_velocity = point_from(*medium);
  model.box = read_box(table_from(dynamics, "box", "it holds the corners min and max"));
  model.contact = read_contact(table_from(dynamics, "contact", "it holds the law between particles"));
  model.wall = read_contact(table_from(dynamics, "wall", "it holds the law between particle and wall"));
  if (auto bond = dynamics.table("bond")) {
    model.bond = read_bond(*bond);
    require_bounded_attraction(*bond, model.bond, model.contact, materials);
  }
  model.schedule = read_phases(dynamics, model, t_end);
  read_particles(table_from(dynamics, "particles", "it holds count and radius, a list, or a file"), materials,
                 initial, seed, placed, input);
  constexpr double usual_skin =
      0.2;  // of the smallest radius: wider lists more pairs, narrower lists oftener
  model.skin = positive_or(dynamics, "skin", usual_skin * smallest_radius(input.particles), "m");
  return input;
}

}  // namespace superstep::dynamics
