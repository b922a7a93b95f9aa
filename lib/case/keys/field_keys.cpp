/// Keys of the fields of particles that do not move.

#include "case/keys/key_list.hpp"

namespace superstep {
namespace {

constexpr unsigned particles = CaseKey::packing;

/// What both fields have: the layer between particles, the values at the start, fixed ones and sources.
void list_inputs(KeyList& keys, const std::string& field, const char* unit, const char* source_unit) {
  keys.in(field, particles);
  keys.boundary("grain_boundary");
  keys.initial(unit, "at t = 0, of the particles that are not fixed; left out = 0");
  keys.list("fixed", CaseKey::table, "particles that are held at a value").may_be_empty = true;
  keys.in(field + ".fixed[]", particles).where("where");
  keys.amount("value", unit, "the value: a number, or a table of time");
  keys.in(field, particles);
  keys.list("source", CaseKey::table, "particles with a source").may_be_empty = true;
  keys.in(field + ".source[]", particles).where("where");
  keys.amount("value", source_unit, "of each particle: a number, or a table of time");
}

}  // namespace

void list_field_keys(KeyList& keys) {
  keys.in("", particles | CaseKey::press).table("thermal", "the scene has a temperature");
  keys.in("thermal", particles).conductivity("W/(m K)");
  keys.number("specific_heat", positive_number, "J/(kg K)", "of the material");
  list_inputs(keys, "thermal", "K", "W");
  keys.in("thermal", particles);
  keys.list("convection", CaseKey::table, "particles that exchange heat with surroundings").may_be_empty =
      true;
  keys.in("thermal.convection[]", particles).where("where");
  keys.number("coefficient", positive_number, "W/(m2 K)", "of the whole surface of a particle");
  keys.amount("ambient", "K", "of the surroundings: a number, or a table of time");
  keys.in("thermal", particles);
  keys.list("radiation", CaseKey::table, "particles that radiate").may_be_empty = true;
  keys.in("thermal.radiation[]", particles).where("where");
  keys.number("emissivity", part, "", "of the surface; of a particle they add up, to 1 at most");
  keys.amount("ambient", "K", "of the surroundings, in kelvin");
  keys.boolean("kelvin", "false", "temperatures below 100 really are kelvin");

  keys.in("", particles | CaseKey::press).table("electric", "the scene has a potential");
  keys.in("electric", particles).conductivity("S/m");
  keys.text("mode", "stepped in time, or solved for", {"transient", "steady"}).fallback = "transient";
  keys.number("specific_capacity", positive_number, "F/kg", "transient only");
  keys.number(
          "settle_tolerance", proper_part, "",
          "of the span: steadier than this is stepped no more, where neither time nor temperature acts on it")
      .fallback = "1e-9";
  keys.number("resolve_change", proper_part, "", "of conductances: steadier than this is not solved anew")
      .fallback = "1e-6";
  list_inputs(keys, "electric", "V", "A");

  keys.in("", particles).table("coupling", "of both fields");
  keys.in("coupling", particles).boolean("joule_heat", "true", "the current heats");
}

}  // namespace superstep
