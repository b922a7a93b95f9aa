#include "integrators/press/model_description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/text/append.hpp"
#include "core/text/text_file.hpp"
#include "dynamics/contacts/bond_registry.hpp"

namespace superstep::dynamics {
namespace {

/// Lines "name = value" with numbers that read back to the last bit.
class Description {
 public:
  template <class Value>
  void add(std::string_view name, const Value& value) {
    append(text_, "{}{} = {}\n", section_, name, value);
  }
  void add(std::string_view name, const Vec3& v) { add(name, fmt::format("[{}, {}, {}]", v.x, v.y, v.z)); }
  void add(std::string_view name, const std::optional<double>& value) {
    add(name, value ? fmt::format("{}", *value) : std::string("none"));
  }
  void begin(const std::string& section) { section_ = section + "."; }
  [[nodiscard]] const std::string& text() const noexcept { return text_; }

 private:
  std::string section_, text_;
};

void add_contact(Description& out, const std::string& section, const ContactLaw& law) {
  out.begin(section);
  out.add("stiffness", law.stiffness);
  out.add("exponent", law.exponent);
  out.add("softening_temperature", law.softening.temperature);
  out.add("stiffness_floor", law.softening.floor);
  out.add("friction", law.friction);
  out.add("friction_speed", law.friction_speed);
  out.add("damping", law.damping);
}

void add_motion(Description& out, const Model& model) {
  out.begin("dynamics");
  out.add("gravity", model.gravity);
  out.add("drag", model.drag.coefficient);
  out.add("medium_velocity", model.drag.medium_velocity);
  out.add("box.min", model.box.min);
  out.add("box.max", model.box.max);
  add_contact(out, "dynamics.contact", model.contact);
  add_contact(out, "dynamics.wall", model.wall);
  out.begin("dynamics.bond");
  out.add("stiffness", model.bond.stiffness);
  out.add("exponent", model.bond.exponent);
  out.add("threshold", model.bond.threshold);
  out.add("rule", bond_kind(model.bond.rule).name);
  out.add("rupture", model.bond.rupture);
  out.add("softening_temperature", model.bond.softening.temperature);
  out.add("stiffness_floor", model.bond.softening.floor);
  out.add("unloading", model.bond.unloading);
  out.add("damping", model.bond.damping);
  const NeckGrowth& growth = model.bond.growth;
  out.begin("dynamics.bond.growth");
  out.add("mechanism", growth.mechanism == NeckGrowth::Mechanism::frenkel ? "frenkel" : "coble");
  out.add("rate", growth.rate);
  out.add("activation_energy", growth.activation);
  out.add("reference_temperature", growth.reference);
  out.add("sintering_stress", growth.sintering_stress);
}

void add_fields(Description& out, const Model& model) {
  out.begin("thermal");
  out.add("conductivity", model.thermal.conductivity);
  out.add("specific_heat", model.thermal.specific_heat);
  for (std::int32_t wall = 0; wall < wall_count; ++wall)
    out.add(fmt::format("walls.{}", wall_name(static_cast<Wall>(wall))),
            model.thermal.wall_temperature[static_cast<std::size_t>(wall)]);
  out.add("walls_conduct", model.thermal.walls_conduct);
  const auto& electric = model.electric;
  out.begin("electric");
  out.add("model", electric.model == CurrentModel::none        ? "none"
                   : electric.model == CurrentModel::averaging ? "averaging"
                                                               : "potential");
  if (electric.model == CurrentModel::none) return;
  out.add("conductivity", electric.conductivity);
  const Saturation& saturation = electric.saturation;
  out.add("saturation", fmt::format("[{}, {}, {}, {}, {}, {}]", saturation.thermal, saturation.thermal_slope,
                                    saturation.temperature, saturation.field, saturation.field_slope,
                                    saturation.reference_field));
  out.add("absorption", electric.absorption);
  out.add("hold_temperature", electric.hold_temperature);
}

void add_schedule(Description& out, const Schedule& schedule, double t) {
  out.begin("dynamics.phases");
  out.add("lowest wall, which the volume fraction refers to", schedule.lowest_wall());
  std::size_t number = 0;
  for (const auto& phase : schedule.phases()) {
    if (phase.begin > t) return;
    out.begin(fmt::format("dynamics.phases[{}]", number++));
    out.add("name", in_quotes(phase.name));
    out.add("begin", phase.begin);
    out.add("wall at its begin", phase.upper_wall_begin);
    out.add("wall speed", phase.wall_velocity());
    out.add("lower electrode", phase.lower);
    out.add("upper electrode", phase.upper);
  }
}

/// The first line of a text, which is taken off it.
std::string_view take_line(std::string_view& text) {
  const auto end = text.find('\n');
  const auto line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

/// Two lines as a message quotes them: of long ones the first word, and where they differ.
std::pair<std::string, std::string> both_in_quotes(std::string_view a, std::string_view b) {
  constexpr std::size_t shown = 40, before = 20;
  const auto differ = static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
  const std::size_t tail = differ > shown ? a.find(' ', differ - before) : std::string_view::npos;
  const auto shortened = [&](std::string_view line) {
    if (tail >= differ) return in_quotes(line);
    return in_quotes(fmt::format("{} ...{}", line.substr(0, line.find(' ')), line.substr(tail)));
  };
  return {shortened(a), shortened(b)};
}

}  // namespace

std::string model_description(const Model& model, double t) {
  Description out;
  add_motion(out, model);
  add_fields(out, model);
  add_schedule(out, model.schedule, t);
  return out.text();
}

void require_same_model(const Checkpoint& stored, const Model& model, const std::string& file,
                        const std::string& case_file) {
  const std::string description = model_description(model, stored.state.time);
  std::string_view there = stored.model, here = description;
  while (!there.empty() || !here.empty()) {
    const auto was = take_line(there), is = take_line(here);
    if (was == is) continue;
    const auto [stood, stands] = both_in_quotes(was, is);
    throw InputError(
        fmt::format("{}: was written with {}, and {} has {}; restart with the case that wrote it", file,
                    stood, case_file, stands));
  }
  const auto phases = static_cast<std::int64_t>(model.schedule.phases().size());
  for (const auto& row : stored.history)
    if (row.phase < 0 || row.phase >= phases)
      throw InputError(
          fmt::format("{}: its history has a phase {}, and {} has {} phases; restart with the case "
                      "that wrote it",
                      file, row.phase + 1, case_file, phases));
}

}  // namespace superstep::dynamics
