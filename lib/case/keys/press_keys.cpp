/// Keys of particles that move.

#include "case/keys/key_list.hpp"

namespace superstep {
namespace {

void list_contact_law(KeyList& keys, const char* name, const char* between) {
  keys.in("dynamics", CaseKey::press).table(name, between);
  keys.in(std::string("dynamics.") + name, CaseKey::press);
  keys.number("stiffness", no_less_than_zero, "N/m2", "of the contact force");
  keys.number("exponent", {.min = 1}, "", "of the strain").fallback = "2";
  keys.number("softening_temperature", positive_number, "K", "the stiffness falls above").fallback = "none";
  keys.number("stiffness_floor", no_less_than_zero, "N/m2", "that it falls to").fallback = "0";
  keys.number("friction", no_less_than_zero, "", "coefficient").fallback = "0";
  keys.number("friction_speed", positive_number, "m/s", "below it friction grows with speed").fallback =
      "0.01";
  keys.number("damping", no_less_than_zero, "", "of the normal motion").fallback = "0";
}

void list_stepping(KeyList& keys) {
  keys.in("dynamics", CaseKey::press).table("stepping", "how time is stepped");
  keys.in("dynamics.stepping", CaseKey::press);
  keys.text("scheme", "of the motion", {"staggered", "plain"}).fallback = "staggered";
  keys.text("control", "of the step", {"steady", "paper"}).fallback = "steady";
  keys.number("phi", part, "", "0 explicit, 1 implicit, 0.5 second order").fallback = "0.5";
  keys.integer("iterations", {.min = 2, .max = 1000}, "wanted in a step").fallback = "10";
  keys.number("tolerance_position", positive_number, "", "of the iteration, not of the result").fallback =
      "5e-4";
  keys.number("tolerance_temperature", positive_number, "", "of the iteration, not of the result").fallback =
      "5e-4";
  keys.number("power", positive_number, "", "p of the contraction h^p").fallback = "2";
  keys.number("first_step", positive_number, "s", "no less than smallest_step").fallback = "0.005";
  keys.number("largest_step", positive_number, "s", "no less than smallest_step").fallback = "0.005";
  keys.number("smallest_step", positive_number, "s", "a shorter one is a failure").fallback = "1e-9";
  keys.number("growth", {.min = 1, .min_open = true}, "", "of a step at most").fallback = "2";
  keys.number("shrink", {.min = 0, .max = 0.9, .min_open = true, .max_open = true}, "", "of a step at most")
      .fallback = "0.1";
  keys.number("fraction", {.min = 0, .max = 2, .min_open = true}, "", "plain: of the stability limit")
      .fallback = "0.5";
}

void list_fields(KeyList& keys) {
  keys.in("thermal", CaseKey::press);
  keys.number("conductivity", no_less_than_zero, "W/(m K)", "of the particles");
  keys.number("specific_heat", positive_number, "J/(kg K)", "of the particles");
  keys.number("initial", no_less_than_zero, "K", "at t = 0");
  keys.number("walls", no_less_than_zero, "K", "temperature of the walls, or one each").types =
      CaseKey::number | CaseKey::table;
  for (const char* wall : {"walls.lower", "walls.upper", "walls.sides"})
    keys.number(wall, no_less_than_zero, "K", "temperature of the wall");
  keys.boolean("walls_conduct", "true", "walls exchange heat with what touches them");

  keys.in("electric", CaseKey::press);
  keys.text("model", "who carries current", {"averaging", "potential"}).fallback = "averaging";
  keys.text("solver", "of the potential", {"conjugate", "direct", "jacobi"}).fallback = "conjugate";
  keys.number("conductivity", positive_number, "S/m", "of the particles");
  keys.number("absorption", part, "", "of the heat of the current").fallback = "1";
  keys.number("tolerance", positive_number, "", "of the solver").fallback = "1e-10";
  keys.table("saturation", "of the conductivity with temperature and field");
  for (const char* key : {"saturation.thermal", "saturation.field"})
    keys.number(key, no_less_than_zero, "", "what it gains at most, in conductivities").fallback = "0";
  keys.number("saturation.thermal_slope", no_less_than_zero, "1/K", "how fast with temperature").fallback =
      "0";
  keys.number("saturation.temperature", no_less_than_zero, "K", "of half the gain").fallback = "300";
  keys.number("saturation.field_slope", no_less_than_zero, "m/V", "how fast with the field").fallback = "0";
  keys.number("saturation.reference_field", no_less_than_zero, "V/m", "from where on").fallback = "0";
  keys.boolean("hold_temperature", "true", "what touches an electrified wall takes its temperature");
}

void list_materials(KeyList& keys) {
  keys.in("", CaseKey::press).list("materials", CaseKey::table, "several materials, one table each");
  keys.in("materials[]", CaseKey::press);
  keys.text("name", "as particles say it");
  keys.number("density", positive_number, "kg/m3", "of its particles");
  keys.table("thermal", "its conductivity and specific heat");
  keys.number("thermal.conductivity", no_less_than_zero, "W/(m K)", "of the material");
  keys.number("thermal.specific_heat", positive_number, "J/(kg K)", "of the material");
  keys.table("electric", "its conductivity, where there is a current");
  keys.number("electric.conductivity", positive_number, "S/m", "of the material");
  keys.number("hardness", positive_number, "", "stiffness of its contacts over that of dynamics.contact")
      .fallback = "1";
  keys.number("share", no_less_than_zero, "", "of particles set at random, by number").fallback = "0";
}

void list_table(KeyList& keys) {
  keys.in("bench", CaseKey::press).table("press_table", "what `superstep bench --press-table` goes through");
  keys.numbers("press_table.hold", 0, positive_number, "s", "how long to hold");
  keys.numbers("press_table.upper_wall", 0, any_number, "m", "lowest heights of the upper wall");
  keys.list("press_table.seeds", CaseKey::integer, "of the particles, where they are generated");
}

void list_phases(KeyList& keys) {
  keys.in("dynamics", CaseKey::press);
  keys.list("phases", CaseKey::table, "pour, press, hold, release: one table each");
  keys.in("dynamics.phases[]", CaseKey::press);
  keys.text("name", "of the phase");
  keys.number("until", positive_number, "s", "its end, later than that of the phase before");
  keys.number("upper_wall", any_number, "m", "height that the upper wall reaches at its end");
  for (const std::string kind : {"current", "potential"}) {
    const char* unit = kind == "current" ? "A" : "V";
    keys.table(kind, "of electrified walls");
    keys.number(kind + ".lower", any_number, unit, "of the lower wall; left out = not electrified");
    keys.number(kind + ".upper", any_number, unit, "of the upper wall; left out = not electrified");
  }
}

}  // namespace

void list_press_keys(KeyList& keys) {
  list_fields(keys);
  list_materials(keys);
  list_table(keys);
  keys.in("", CaseKey::press).table("dynamics", "the particles move");
  keys.in("dynamics", CaseKey::press);
  keys.number("gravity", no_less_than_zero, "m/s2", "downwards").fallback = "9.81";
  keys.number("drag", no_less_than_zero, "kg/(m s)", "of the medium").fallback = "0";
  keys.numbers("medium_velocity", 3, any_number, "m/s", "of the medium").fallback = "[0, 0, 0]";
  keys.number("skin", positive_number, "m", "of the list of neighbours").fallback = "0.2 smallest radii";
  keys.text("thermal_integrator", "staggered, or any SPEC").fallback = "staggered";
  keys.table("box", "the walls");
  keys.numbers("box.min", 3, any_number, "m", "lower corner");
  keys.numbers("box.max", 3, any_number, "m", "upper corner; its z is where the upper wall begins");
  keys.table("particles", "how many and where");
  keys.integer("particles.count", {.min = 1, .max = 100'000'000}, "particles set at random");
  keys.number("particles.radius", positive_number, "m", "of those");
  keys.integer("particles.seed", no_less_than_zero, "of the random numbers").fallback = "1";
  keys.list("particles.list", CaseKey::table, "or one table each");
  keys.text("particles.file", "or a packing in any format");
  keys.text("particles.length_unit", "of that file").fallback = "m";
  keys.number("particles.velocity_unit", positive_number, "m/s", "of its velocities").fallback =
      "that of its unit style, else its unit of length per second";
  keys.text("particles.bonds", "CSV with i, j, overlap, growth of its bonds");
  keys.numbers("particles.shift", 3, any_number, "m", "added to its centres").fallback = "[0, 0, 0]";
  keys.number("particles.max_overlap", proper_part, "", "at the start, of the sum of two radii").fallback =
      "0";
  list_sizes(keys.in("dynamics.particles", CaseKey::press), "m");
  keys.in("dynamics.particles.list[]", CaseKey::press);
  keys.numbers("position", 3, any_number, "m", "its centre");
  keys.number("radius", positive_number, "m", "its radius");
  keys.numbers("velocity", 3, any_number, "m/s", "its velocity").fallback = "[0, 0, 0]";
  keys.number("temperature", no_less_than_zero, "K", "at t = 0").fallback = "thermal.initial";
  keys.text("material", "one of materials, where there are several");
  list_contact_law(keys, "contact", "force between two particles");
  list_contact_law(keys, "wall", "force between a particle and a wall");
  keys.in("dynamics", CaseKey::press).table("bond", "hot contacts bond; left out = none do");
  keys.in("dynamics.bond", CaseKey::press);
  keys.number("stiffness", no_less_than_zero, "N/m2", "of the bond; below that of the contact, or a neck's");
  keys.number("exponent", {.min = 1}, "", "of the strain; not of a neck").fallback = "2";
  keys.number("threshold", positive_number, "", "overlap strain at which it forms");
  keys.text("rule", "where it acts", {"overlap", "tension", "rest-length"}).fallback = "overlap";
  keys.number("rupture", positive_number, "", "strain at which it breaks").fallback = "0.05, rest-length 0.2";
  keys.number("softening_temperature", positive_number, "K", "the stiffness falls above").fallback = "none";
  keys.number("stiffness_floor", no_less_than_zero, "N/m2", "that it falls to").fallback = "0";
  keys.number("unloading", positive_number, "", "rest-length: strain within which repulsion is lost")
      .fallback = "0.02";
  keys.number("damping", no_less_than_zero, "", "rest-length: share of critical").fallback = "0";
  keys.table("growth", "rest-length: how the neck grows");
  keys.in("dynamics.bond.growth", CaseKey::press);
  keys.text("mechanism", "of sintering", {"frenkel", "coble"}).fallback = "frenkel";
  keys.number("rate", no_less_than_zero, "1/s", "at the reference temperature");
  keys.number("activation_energy", no_less_than_zero, "J/mol", "of the Arrhenius factor").fallback = "0";
  keys.number("reference_temperature", positive_number, "K", "of the rate").fallback = "1000";
  keys.number("sintering_stress", positive_number, "Pa", "pressure of a contact that doubles the rate")
      .fallback = "none";
  list_phases(keys);
  list_stepping(keys);
}

}  // namespace superstep
