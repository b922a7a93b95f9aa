#include "bench/app/cli_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "bench/output/machine.hpp"
#include "core/error.hpp"
#include "core/suggest.hpp"
#include "core/text_file.hpp"

namespace superstep {
namespace {

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

void add_common(CLI::App& app, Arguments& values) {
  app.add_option("--threads", values.threads, "threads that may compute (default 1)")->type_name("N");
  app.add_flag("--quiet", values.quiet, "no progress, notes or warnings on stderr");
  app.add_flag("--json", values.json, "machine-readable output on stdout");
  app.add_option("--color", values.color, "colours on stdout: auto, always or never (default auto)")
      ->type_name("WHEN");
}

CLI::App& add_command(CLI::App& app, Arguments& values, const std::string& name, const std::string& does,
                      const std::string& examples) {
  CLI::App& command = *app.add_subcommand(name, does);
  command.allow_extras();
  command.footer("Examples:\n" + examples);
  add_common(command, values);
  return command;
}

void add_case(CLI::App& command, Arguments& values, bool several) {
  command.add_option("CASE", values.cases, several ? "case files (TOML)" : "case file (TOML)")->type_name("");
}

// A list that takes one value per mention: it must not swallow the case file that follows.
void add_integrators(CLI::App& command, Arguments& values, const std::string& fallback) {
  command.add_option("--integrator", values.integrators, "integrator, may be repeated; default: " + fallback)
      ->type_name("SPEC")
      ->allow_extra_args(false);
}

void add_run(CLI::App& app, Arguments& values) {
  auto& command = add_command(
      app, values, "run", "integrate a case and write its fields",
      "  superstep run cases/nial_thermal.toml --tolerance 1e-3\n"
      "  superstep run cases/nial_thermal.toml --integrator sts:n=20,nu=1e-3 --out result\n"
      "  superstep run cases/nial_thermal.toml --integrator cvode --tolerance 1e-7\n"
      "  superstep run cases/nial_thermal.toml --vtk --out result   (then open result/vtk/particles.pvd)\n"
      "  superstep run cases/sintering_example.toml --out result --checkpoint 0.1\n"
      "  superstep run cases/sintering_example.toml --restart result/checkpoint.bin");
  add_case(command, values, false);
  add_integrators(command, values, "auto");
  command
      .add_option("--tolerance", values.tolerance,
                  "error allowed relative to the field's span, instead of the SPEC's rtol")
      ->type_name("X");
  command.add_option("--out", values.out, "folder for final.csv, probes.csv, run.json")->type_name("DIR");
  command.add_flag(
      "--verify", values.verify,
      "run again by a method of another family, ten times tighter, and print the error delivered");
  command.add_flag("--vtk", values.vtk, "write particles and contacts at every output time for ParaView");
  command
      .add_option("--checkpoint", values.checkpoint,
                  "moving particles: simulated time [s] between writes of DIR/checkpoint.bin")
      ->type_name("T");
  command.add_option("--restart", values.restart, "moving particles: go on from this checkpoint")
      ->type_name("FILE");
}

void add_bench(CLI::App& app, Arguments& values) {
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
          "method that errors are measured against, or none (default CVODE with KLU at 1e-9, on large "
          "networks and with --work-precision the exponential where it is exact)")
      ->type_name("SPEC");
  command.add_flag("--work-precision", values.work_precision,
                   "sweep every method over tolerances and steps; say who is fastest at each error");
  command.add_flag("--report", values.report, "write report.html beside the results as well");
  command.add_flag("--no-cache", values.no_cache, "neither read nor write cached references");
}

void add_report(CLI::App& app, Arguments& values) {
  auto& command =
      add_command(app, values, "report", "one HTML file from the results of bench, run and stability",
                  "  superstep report reports/out/nial_thermal\n"
                  "  superstep bench cases/nial_thermal.toml --out result && superstep report result\n"
                  "  superstep report result --markdown --against earlier");
  command.add_option("DIR", values.cases, "folder with results.json, run.json or both")->type_name("");
  command.add_flag("--markdown", values.markdown, "print a summary for continuous integration as well");
  command
      .add_option("--against", values.against, "with --markdown: list only what changed since that benchmark")
      ->type_name("DIR");
}

void add_completion(CLI::App& app, Arguments& values) {
  auto& command = add_command(app, values, "completion", "completion script for a shell",
                              "  source <(superstep completion bash)\n"
                              "  source <(superstep completion zsh)\n"
                              "  superstep completion fish | source");
  command.add_option("SHELL", values.cases, "bash, zsh or fish")->type_name("");
}

void add_info(CLI::App& app, Arguments& values) {
  auto& command = add_command(app, values, "info", "health of a case's network, without integrating it",
                              "  superstep info cases/nial_thermal.toml\n"
                              "  superstep info cases/nial_thermal.toml --json");
  add_case(command, values, false);
}

void add_stability(CLI::App& app, Arguments& values) {
  auto& command = add_command(app, values, "stability",
                              "stability laboratory: where each method is safe on a case, and where not",
                              "  superstep stability cases/nial_thermal.toml\n"
                              "  superstep stability cases/chain.toml --quick\n"
                              "  superstep stability cases/lattice_two_way.toml --quick\n"
                              "  superstep stability cases/nial_thermal.toml --out result --json");
  add_case(command, values, false);
  command
      .add_option(
          "--out", values.out,
          "folder for stability_*.csv: methods, critical_step, rounding, sweeps, states (default: none)")
      ->type_name("DIR");
  command.add_flag("--quick", values.quick, "fewer parameter sets, done in seconds");
}

void add_gate(CLI::App& app, Arguments& values) {
  auto& gate = add_command(app, values, "gate",
                           "is this build as good as a recorded one? exit 0 yes, 5 no, 6 cannot tell",
                           "  superstep bench cases/nial_thermal.toml --repetitions 11 --out result\n"
                           "  superstep gate result --baseline reports/baselines/nial_thermal.json");
  gate.add_option("RESULTS", values.cases, "results.json of superstep bench, or its folder")->type_name("");
  gate.add_option("--baseline", values.baseline, "the recorded results.json")->type_name("FILE");
  auto& compare = add_command(app, values, "compare", "two sets of results side by side, with intervals",
                              "  superstep compare before after");
  compare.add_option("RESULTS", values.cases, "results.json of superstep bench, or their folders")
      ->type_name("");
}

void add_pack(CLI::App& app, Arguments& values) {
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

// An empty value is a slip, such as an unset shell variable; taking it as "not given" would hide that.
void reject_empty_values(const CLI::App& command) {
  for (const auto* option : command.get_options())
    for (const auto& value : option->results())
      if (value.empty()) throw UsageError(fmt::format("{}: the value is empty", option->get_name()));
}

std::string version_text() {
  const std::string revision = program_revision();
  return fmt::format("superstep {}{}\n", program_version(), revision.empty() ? "" : " (" + revision + ")");
}

void add_commands(CLI::App& app, Arguments& values) {
  add_run(app, values);
  add_bench(app, values);
  add_info(app, values);
  add_stability(app, values);
  add_gate(app, values);
  add_pack(app, values);
  add_report(app, values);
  add_completion(app, values);
  add_command(app, values, "list", "integrators with their keys, neck laws and cases",
              "  superstep list\n  superstep list --json");
}

}  // namespace

Arguments read_arguments(const std::vector<std::string>& line) {
  CLI::App app("Superstep: which time integrator is fastest for heat and current in packings of particles?",
               "superstep");
  app.require_subcommand(0, 1);
  app.allow_extras();
  app.footer("Each command has its own --help with examples.");
  Arguments values;
  bool version = false;
  app.add_flag("--version", version, "print the version");
  add_common(app, values);
  add_commands(app, values);
  try {
    app.parse(std::vector<std::string>(line.rbegin(), line.rend()));  // CLI11 takes them from the back
  } catch (const CLI::CallForHelp&) {
    values.text = app.help();
    return values;
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
  if (version) {
    values.text = version_text();
    return values;
  }
  reject_unknown_arguments(app);
  const auto chosen = app.get_subcommands();
  if (chosen.empty())
    throw UsageError(
        fmt::format("a command is missing{}; see superstep --help", suggestion("", names_of_commands(app))));
  reject_unknown_arguments(*chosen.front());
  reject_empty_values(*chosen.front());
  values.command = chosen.front()->get_name();
  return values;
}

std::vector<CommandShape> command_shapes() {
  CLI::App app;
  Arguments values;
  add_commands(app, values);
  std::vector<CommandShape> shapes;
  for (const auto* command : app.get_subcommands(nullptr)) {
    CommandShape shape{.name = command->get_name(), .does = command->get_description(), .options = {}};
    for (const auto* option : command->get_options())
      for (const auto& name : option->get_lnames())
        shape.options.push_back(
            {.name = "--" + name,
             .meaning = option->get_description(),
             .takes_value = option->get_expected_max() > 0 && option->get_items_expected_max() > 0,
             .words = {}});
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

}  // namespace superstep
