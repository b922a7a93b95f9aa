#include "bench/cli.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "bench/cli_values.hpp"
#include "bench/machine.hpp"
#include "core/error.hpp"
#include "core/suggest.hpp"
#include "core/text_file.hpp"

namespace superstep {
namespace {

constexpr std::int64_t unlimited = std::numeric_limits<std::int64_t>::max();

/// Every value of the command line as it was written; empty = not given.
struct Values {
  std::string threads = "1", color = "auto";
  bool quiet = false, json = false;

  std::vector<std::string> cases, integrators;
  std::string tolerance, out, reference;
  std::optional<std::string> repetitions;
  bool no_cache = false, work_precision = false, quick = false;

  std::string container = "cylinder", diameter, width, depth, height, count, relative_density, sizes,
              seed = "1", length_unit = "m", file;
};

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> names_of_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* option : app.get_options())
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// Unknown arguments are collected by CLI11 and judged here, so that the message can name what was meant.
void reject_unknown_arguments(const CLI::App& app) {
  for (const auto& argument : app.remaining()) {
    const bool option = argument.starts_with("-");
    const std::string name = argument.substr(0, argument.find('='));
    if (option)
      throw UsageError(fmt::format("unknown option {}{}", superstep::quoted(name),
                                   suggestion(name, names_of_options(app))));
    if (app.get_parent() == nullptr)
      throw UsageError(fmt::format("unknown command {}{}", superstep::quoted(name),
                                   suggestion(name, names_of_commands(app))));
    throw UsageError(fmt::format("{}: unexpected argument {}; see superstep {} --help", app.get_name(),
                                 superstep::quoted(argument), app.get_name()));
  }
}

void add_common(CLI::App& app, Values& values) {
  app.add_option("--threads", values.threads, "threads that may compute (default 1)")->type_name("N");
  app.add_flag("--quiet", values.quiet, "no progress, notes or warnings on stderr");
  app.add_flag("--json", values.json, "machine-readable output on stdout");
  app.add_option("--color", values.color, "colours on stdout: auto, always or never (default auto)")
      ->type_name("WHEN");
}

CLI::App& add_command(CLI::App& app, Values& values, const std::string& name, const std::string& does,
                      const std::string& examples) {
  CLI::App& command = *app.add_subcommand(name, does);
  command.allow_extras();
  command.footer("Examples:\n" + examples);
  add_common(command, values);
  return command;
}

void add_case(CLI::App& command, Values& values, bool several) {
  command.add_option("CASE", values.cases, several ? "case files (TOML)" : "case file (TOML)")->type_name("");
}

// A list that takes one value per mention: it must not swallow the case file that follows.
void add_integrators(CLI::App& command, Values& values, const std::string& fallback) {
  command.add_option("--integrator", values.integrators, "integrator, may be repeated; default: " + fallback)
      ->type_name("SPEC")
      ->allow_extra_args(false);
}

void add_run(CLI::App& app, Values& values) {
  auto& command =
      add_command(app, values, "run", "integrate a case and write its fields",
                  "  superstep run cases/nial_thermal.toml --tolerance 1e-3\n"
                  "  superstep run cases/nial_thermal.toml --integrator sts:n=20,nu=1e-3 --out result\n"
                  "  superstep run cases/nial_thermal.toml --integrator cvode --tolerance 1e-7");
  add_case(command, values, false);
  add_integrators(command, values, "auto");
  command
      .add_option("--tolerance", values.tolerance,
                  "error allowed relative to the field's span, instead of the SPEC's rtol")
      ->type_name("X");
  command.add_option("--out", values.out, "folder for final.csv, probes.csv, run.json")->type_name("DIR");
}

void add_bench(CLI::App& app, Values& values) {
  auto& command = add_command(app, values, "bench", "measure integrators on a case: CPU time, speedup, error",
                              "  superstep bench cases/nial_thermal.toml\n"
                              "  superstep bench cases/nial_thermal.toml --integrator sts:n=20,nu=1e-3 "
                              "--repetitions 5\n"
                              "  superstep bench cases/nial_thermal.toml --work-precision\n"
                              "  superstep bench cases/nial_thermal.toml --reference forward-euler --json");
  add_case(command, values, true);
  add_integrators(command, values, "those of the case");
  command
      .add_option("--repetitions", values.repetitions,
                  "timed runs of each integrator (default 3; 1 with --work-precision)")
      ->type_name("N");
  command.add_option("--out", values.out, "folder for results.csv and results.json")->type_name("DIR");
  command
      .add_option(
          "--reference", values.reference,
          "method that errors are measured against, or none (default cvode:rtol=1e-9; with --work-precision "
          "the exponential where the scene is linear)")
      ->type_name("SPEC");
  command.add_flag("--work-precision", values.work_precision,
                   "sweep every method over tolerances and steps; say who is fastest at each error");
  command.add_flag("--no-cache", values.no_cache, "neither read nor write cached references");
}

void add_info(CLI::App& app, Values& values) {
  auto& command = add_command(app, values, "info", "health of a case's network, without integrating it",
                              "  superstep info cases/nial_thermal.toml\n"
                              "  superstep info cases/nial_thermal.toml --json");
  add_case(command, values, false);
}

void add_stability(CLI::App& app, Values& values) {
  auto& command = add_command(app, values, "stability",
                              "stability laboratory: where each method is safe on a case, and where not",
                              "  superstep stability cases/nial_thermal.toml\n"
                              "  superstep stability cases/chain.toml --quick\n"
                              "  superstep stability cases/nial_thermal.toml --out result --json");
  add_case(command, values, false);
  command
      .add_option("--out", values.out,
                  "folder for stability_*.csv: methods, critical_step, rounding, sweeps (default: none)")
      ->type_name("DIR");
  command.add_flag("--quick", values.quick, "fewer parameter sets, done in seconds");
}

void add_pack(CLI::App& app, Values& values) {
  auto& command = add_command(
      app, values, "pack", "generate a packing of spheres",
      "  superstep pack --container cylinder --diameter 123.6 --height 166 --length-unit um "
      "--relative-density 0.784 \\\n"
      "      --count 17515 --sizes lognormal:median=4,sigma=0.5,min=1.5,max=20 --seed 1 -o packing.csv\n"
      "  superstep pack --container box --width 1 --depth 1 --height 1 --length-unit mm --relative-density "
      "0.6 \\\n"
      "      --sizes uniform:min=0.08,max=0.12 -o packing.csv");
  const auto add = [&](const std::string& name, std::string& value, const std::string& meaning,
                       const char* type) { command.add_option(name, value, meaning)->type_name(type); };
  add("--container", values.container, "cylinder or box (default cylinder)", "SHAPE");
  add("--diameter", values.diameter, "of the cylinder", "L");
  add("--width", values.width, "of the box, x", "L");
  add("--depth", values.depth, "of the box, y", "L");
  add("--height", values.height, "of the container, z", "L");
  add("--count", values.count, "number of spheres; default: as many as density and sizes ask for", "N");
  add("--relative-density", values.relative_density, "sphere volume over container volume (default 0.64)",
      "X");
  add("--sizes", values.sizes,
      "diameters: lognormal:median=,sigma=,min=,max= | uniform:min=,max= | list:d1,d2,...", "SIZES");
  add("--seed", values.seed, "same seed, same packing (default 1)", "N");
  add("--length-unit", values.length_unit, "of the lengths given here: m, cm, mm, um, nm (default m)",
      "UNIT");
  add("-o,--output", values.file, "packing file to write (CSV in metres)", "FILE");
}

CommonOptions common_options(const Values& values) {
  return {.threads = static_cast<int>(parse_integer_option("--threads", values.threads, 1, 1024)),
          .quiet = values.quiet,
          .json = values.json,
          .color = parse_color_mode(values.color)};
}

const std::string& single_case(const Values& values, const std::string& command) {
  if (values.cases.empty())
    throw UsageError(fmt::format("{0}: a case file is missing; see superstep {0} --help", command));
  if (values.cases.size() > 1)
    throw UsageError(fmt::format("{0}: unexpected argument {1}; see superstep {0} --help", command,
                                 superstep::quoted(values.cases[1])));
  return values.cases.front();
}

Command make_run(const Values& values) {
  RunCommand command{.common = common_options(values),
                     .case_file = single_case(values, "run"),
                     .integrators = values.integrators,
                     .tolerance = std::nullopt,
                     .out = values.out};
  if (!values.tolerance.empty()) command.tolerance = parse_positive_option("--tolerance", values.tolerance);
  return command;
}

int repetitions_of(const Values& values, int fallback) {
  if (!values.repetitions) return fallback;
  return static_cast<int>(parse_integer_option("--repetitions", *values.repetitions, 1, 10000));
}

Command make_work_precision(const Values& values) {
  if (values.json) throw UsageError("bench: --work-precision writes CSV and a table; leave --json out");
  if (values.reference == "none")
    throw UsageError("bench: --work-precision needs a reference; leave --reference none out");
  WorkPrecisionCommand command;
  command.common = common_options(values);
  command.case_files = values.cases;
  command.out = values.out;
  command.options.integrators = values.integrators;
  command.options.reference = values.reference;
  command.options.use_cache = !values.no_cache;
  command.options.repetitions = repetitions_of(values, 1);
  return command;
}

Command make_bench(const Values& values) {
  if (values.cases.empty()) throw UsageError("bench: a case file is missing; see superstep bench --help");
  if (values.work_precision) return make_work_precision(values);
  BenchCommand command;
  command.common = common_options(values);
  command.case_files = values.cases;
  command.out = values.out;
  command.harness.integrators = values.integrators;
  if (!values.reference.empty()) command.harness.reference = values.reference;
  command.harness.use_cache = !values.no_cache;
  command.harness.repetitions = repetitions_of(values, command.harness.repetitions);
  return command;
}

Command make_stability(const Values& values) {
  return StabilityCommand{.common = common_options(values),
                          .case_file = single_case(values, "stability"),
                          .out = values.out,
                          .quick = values.quick};
}

Container container_of(const Values& values, double unit) {
  const auto length = [&](const char* option, const std::string& text) {
    if (text.empty()) throw UsageError(fmt::format("pack: {} is missing for a {}", option, values.container));
    return unit * parse_positive_option(option, text);
  };
  Container container;
  container.height = length("--height", values.height);
  if (values.container == "cylinder") {
    if (!values.width.empty() || !values.depth.empty())
      throw UsageError("pack: --width and --depth belong to a box; a cylinder has --diameter");
    container.diameter = length("--diameter", values.diameter);
  } else if (values.container == "box") {
    if (!values.diameter.empty())
      throw UsageError("pack: --diameter belongs to a cylinder; a box has --width, --depth");
    container.shape = Container::Shape::box;
    container.width = length("--width", values.width);
    container.depth = length("--depth", values.depth);
  } else {
    const std::vector<std::string> shapes = {"cylinder", "box"};
    throw UsageError(fmt::format("--container {} is not valid{}", superstep::quoted(values.container),
                                 suggestion(values.container, shapes)));
  }
  return container;
}

Command make_pack(const Values& values) {
  PackCommand command{.common = common_options(values), .settings = {}, .file = values.file};
  if (command.file.empty()) throw UsageError("pack: -o FILE is missing; see superstep pack --help");
  if (values.sizes.empty()) throw UsageError("pack: --sizes is missing; see superstep pack --help");
  const double unit = parse_length_unit(values.length_unit);
  PackSettings& settings = command.settings;
  settings.container = container_of(values, unit);
  settings.sizes = parse_sizes(values.sizes, unit);
  if (!values.relative_density.empty())
    settings.relative_density = parse_positive_option("--relative-density", values.relative_density);
  if (!values.count.empty())
    settings.count = static_cast<std::size_t>(parse_integer_option("--count", values.count, 1, unlimited));
  settings.seed = static_cast<std::uint64_t>(parse_integer_option("--seed", values.seed, 0, unlimited));
  return command;
}

Command make_command(const std::string& name, const Values& values) {
  if (name == "run") return make_run(values);
  if (name == "bench") return make_bench(values);
  if (name == "info") return InfoCommand{common_options(values), single_case(values, "info")};
  if (name == "stability") return make_stability(values);
  if (name == "pack") return make_pack(values);
  return ListCommand{common_options(values)};
}

std::string version_text() {
  const std::string revision = program_revision();
  return fmt::format("superstep {}{}\n", program_version(), revision.empty() ? "" : " (" + revision + ")");
}

}  // namespace

Command parse_command_line(const std::vector<std::string>& arguments) {
  CLI::App app("Superstep: which time integrator is fastest for heat and current in packings of particles?",
               "superstep");
  app.require_subcommand(0, 1);
  app.allow_extras();
  app.footer("Each command has its own --help with examples.");
  bool version = false;
  app.add_flag("--version", version, "print the version");
  Values values;
  add_common(app, values);
  add_run(app, values);
  add_bench(app, values);
  add_info(app, values);
  add_stability(app, values);
  add_pack(app, values);
  add_command(app, values, "list", "integrators with their keys, neck laws and cases",
              "  superstep list\n  superstep list --json");
  try {
    app.parse(
        std::vector<std::string>(arguments.rbegin(), arguments.rend()));  // CLI11 takes them from the back
  } catch (const CLI::CallForHelp&) {
    return ShowText{app.help()};
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  if (version) return ShowText{version_text()};
  reject_unknown_arguments(app);
  const auto chosen = app.get_subcommands();
  if (chosen.empty())
    throw UsageError("a command is missing" + suggestion("", names_of_commands(app)) +
                     "; see superstep --help");
  reject_unknown_arguments(*chosen.front());
  return make_command(chosen.front()->get_name(), values);
}

}  // namespace superstep
