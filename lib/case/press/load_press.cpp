#include <fmt/format.h>

#include <utility>

#include "case/press/press.hpp"
#include "case/press/read_model.hpp"
#include "case/press/read_values.hpp"
#include "core/error.hpp"

namespace superstep {
namespace {

using namespace dynamics;

/// Numbers whose range has two ends.
void require_ranges(TomlTable& table) {
  struct Range {
    const char* key;
    bool (*holds)(double);
    const char* rule;
  };
  for (const auto& [key, holds, rule] :
       {Range{"phi", [](double x) { return x >= 0 && x <= 1; }, "it must lie between 0 and 1"},
        Range{"growth", [](double x) { return x > 1; }, "it must be > 1"},
        Range{"shrink", [](double x) { return x > 0 && x < 0.9; }, "it must be > 0 and < 0.9"},
        Range{"fraction", [](double x) { return x > 0 && x <= 2; }, "it must be > 0 and at most 2"}})
    if (const auto value = table.find(key); value && !holds(value->number())) value->reject(rule);
}

void read_stepping(TomlTable dynamics, Press& press) {
  SteppingSettings& settings = press.stepping;
  if (const auto spec = dynamics.find("thermal_integrator")) {
    settings.thermal_integrator = spec->string() == "staggered" ? "" : spec->string();
    if (!settings.thermal_integrator.empty()) press.stated_specs.push_back({spec->string(), spec->where()});
  }
  if (!dynamics.find("stepping")) return;
  TomlTable table = *dynamics.table("stepping");
  require_ranges(table);
  settings.scheme = word_from(table, "scheme", {"staggered", "plain"}, "staggered") == "plain"
                        ? SteppingSettings::Scheme::plain
                        : SteppingSettings::Scheme::staggered;
  settings.control = word_from(table, "control", {"steady", "paper"}, "steady") == "paper"
                         ? SteppingSettings::Control::paper
                         : SteppingSettings::Control::steady;
  settings.phi = number_from(table, "phi", 0, settings.phi, "-");
  if (const auto iterations = table.find("iterations")) {
    if (iterations->integer() < 2 || iterations->integer() > 1000)
      iterations->reject("it must lie between 2 and 1000");
    settings.iterations = static_cast<int>(iterations->integer());
  }
  settings.tolerance_position = positive_or(table, "tolerance_position", settings.tolerance_position, "-");
  settings.tolerance_temperature =
      positive_or(table, "tolerance_temperature", settings.tolerance_temperature, "-");
  settings.power = positive_or(table, "power", settings.power, "-");
  settings.first_step = positive_or(table, "first_step", settings.first_step, "s");
  settings.largest_step = positive_or(table, "largest_step", settings.largest_step, "s");
  settings.smallest_step = positive_or(table, "smallest_step", settings.smallest_step, "s");
  settings.bounds.growth = positive_or(table, "growth", settings.bounds.growth, "-");
  settings.bounds.shrink = positive_or(table, "shrink", settings.bounds.shrink, "-");
  settings.fraction = positive_or(table, "fraction", settings.fraction, "-");
  try {
    check_settings(settings);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", table.where(), error.what()));
  }
}

/// What only the stepping and the laws together tell.
void warn_of_gain(Press& press) {
  const SteppingSettings& settings = press.stepping;
  const bool undamped = !(press.model.contact.damping > 0 && press.model.wall.damping > 0);
  if (settings.scheme != SteppingSettings::Scheme::staggered || settings.phi >= 0.5 || !undamped) return;
  press.warnings.push_back(fmt::format(
      "with phi = {} < 0.5 every contact without damping gives back more energy than it took, at any step; "
      "take phi = 0.5, or give [dynamics.contact] and [dynamics.wall] a damping",
      settings.phi));
}

void read_motion_window(TomlTable& root, Press& press) {
  auto bench = root.table("bench");
  const auto window = bench ? bench->find("motion_window") : std::nullopt;
  if (!window) return;
  const auto ends = window->numbers();
  if (ends.size() != 2 || !(ends[0] >= 0 && ends[0] < ends[1] && ends[1] <= press.t_end))
    window->reject(
        fmt::format("it must be [from, to] in s with 0 <= from < to <= t_end = {} s", press.t_end));
  press.motion_window = {ends[0], ends[1]};
}

/// Whether particles are generated: they have a seed then.
bool generates(TomlTable& root) {
  auto dynamics = root.table("dynamics");
  auto particles = dynamics ? dynamics->table("particles") : std::nullopt;
  return particles && !particles->find("list") && !particles->find("file");
}

std::vector<std::int64_t> read_seeds(TomlTable& table, bool generated) {
  if (!generated) {
    if (const auto seeds = table.find("seeds"))
      seeds->reject("only generated particles have seeds; remove it, or give [dynamics.particles] a count");
    return {};
  }
  const auto seeds = table.require("seeds", "it lists seeds of the particles");
  std::vector<std::int64_t> out;
  for (const auto& seed : seeds.array()) {
    if (seed.integer() < 0) seed.reject("it must be >= 0");
    out.push_back(seed.integer());
  }
  if (out.empty()) seeds.reject("there must be at least one");
  return out;
}

void read_press_table(TomlTable& root, Press& press) {
  auto bench = root.table("bench");
  auto table = bench ? bench->table("press_table") : std::nullopt;
  if (!table) return;
  Press::Table axes;
  const auto numbers = [&](const char* key, const char* why) {
    const auto value = table->require(key, why);
    auto list = value.numbers();
    if (list.empty()) value.reject("it must hold at least one number");
    return list;
  };
  axes.holds = numbers("hold", "it lists how long to hold [s]");
  axes.walls = numbers("upper_wall", "it lists lowest heights of the upper wall [m]");
  for (const double hold : axes.holds)
    if (!(hold > 0)) table->find("hold")->reject("every hold must be > 0 s");
  axes.seeds = read_seeds(*table, generates(root));
  table->finish();
  press.table = std::move(axes);
}

}  // namespace

Press load_press(const std::string& path) {
  return load_press(TomlTable::parse_file(path));
}

Press load_press(const std::string& path, std::uint64_t seed) {
  return load_press(TomlTable::parse_file(path), seed);
}

Press load_press(TomlTable root, std::optional<std::uint64_t> seed, const dynamics::Placed& placed) {
  for (const char* key : {"title", "source", "t_end", "output_times", "bench", "corpus", "material",
                          "materials", "thermal", "electric", "dynamics"})
    (void)root.find(key);
  root.finish();  // a misspelt table is said first: what follows would only miss it
  Press press;
  read_head(root, press);
  read_motion_window(root, press);
  ModelInput input = read_model(root, press.t_end, seed, placed);
  read_stepping(*root.table("dynamics"), press);
  read_press_table(root, press);
  root.finish();
  press.model = std::move(input.model);
  press.particles = std::move(input.particles);
  press.state = std::move(input.state);
  press.warnings = std::move(input.warnings);
  warn_of_gain(press);
  return press;
}

}  // namespace superstep
