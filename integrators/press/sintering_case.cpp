#include "integrators/press/sintering_case.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "case/press/read_values.hpp"
#include "core/error.hpp"
#include "integrators/registry.hpp"

namespace superstep::dynamics {
namespace {

std::vector<double> read_output_times(TomlTable& root, double t_end) {
  const auto value = root.find("output_times");
  if (!value) return {t_end};
  std::vector<double> times = value->numbers();
  double previous = 0;
  for (const double t : times) {
    if (!(t > previous) || t > t_end)
      value->reject(fmt::format("the times must be > 0, ascending and none after t_end = {} s", t_end));
    previous = t;
  }
  if (times.empty()) value->reject("there must be at least one time");
  if (previous < t_end) times.push_back(t_end);
  return times;
}

/// A SPEC out of a case file: what is wrong with it is the file's fault.
void check_spec(const std::string& spec, const std::string& where) {
  try {
    (void)make_integrator(spec);
  } catch (const UsageError& error) {
    throw InputError(fmt::format("{}: {}", where, error.what()));
  }
}

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

SteppingSettings read_stepping(TomlTable dynamics) {
  SteppingSettings settings;
  if (const auto spec = dynamics.find("thermal_integrator")) {
    settings.thermal_integrator = spec->string() == "staggered" ? "" : spec->string();
    if (!settings.thermal_integrator.empty()) check_spec(spec->string(), spec->where());
  }
  if (!dynamics.find("stepping")) return settings;
  TomlTable table = *dynamics.table("stepping");
  require_ranges(table);
  settings.scheme = word_from(table, "scheme", {"staggered", "plain"}, "staggered") == "plain"
                        ? SteppingSettings::Scheme::plain
                        : SteppingSettings::Scheme::staggered;
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
  return settings;
}

void read_bench(TomlTable& root, SinteringCase& one) {
  auto bench = root.table("bench");
  if (!bench) return;
  if (const auto baseline = bench->find("baseline")) {
    one.baseline = baseline->string();
    check_spec(one.baseline, baseline->where());
  }
  if (const auto integrators = bench->find("integrators")) {
    one.integrators = integrators->strings();
    for (const auto& spec : one.integrators) check_spec(spec, integrators->where());
  }
  if (const auto window = bench->find("motion_window")) {
    const auto ends = window->numbers();
    if (ends.size() != 2 || !(ends[0] >= 0 && ends[0] < ends[1] && ends[1] <= one.t_end))
      window->reject(
          fmt::format("it must be [from, to] in s with 0 <= from < to <= t_end = {} s", one.t_end));
    one.motion_window = {ends[0], ends[1]};
  }
}

}  // namespace

bool is_sintering_case(const std::string& path) {
  return TomlTable::parse_file(path).find("dynamics").has_value();
}

SinteringCase load_sintering_case(const std::string& path) {
  return load_sintering_case(TomlTable::parse_file(path));
}

SinteringCase load_sintering_case(TomlTable root) {
  const std::string path = root.file();
  for (const char* key :
       {"title", "source", "t_end", "output_times", "bench", "material", "thermal", "electric", "dynamics"})
    (void)root.find(key);
  root.finish();  // a misspelt table is said first: what follows would only miss it
  SinteringCase one;
  one.file = path;
  one.name = std::filesystem::path(path).stem().string();
  one.title = root.string("title").value_or(one.name);
  one.source = root.string("source").value_or("");
  one.t_end = root.positive("t_end", "s");
  one.output_times = read_output_times(root, one.t_end);
  read_bench(root, one);
  ModelInput input = read_model(root, one.t_end);
  one.stepping = read_stepping(*root.table("dynamics"));
  root.finish();
  one.model = std::move(input.model);
  one.particles = std::move(input.particles);
  one.state = std::move(input.state);
  return one;
}

}  // namespace superstep::dynamics
