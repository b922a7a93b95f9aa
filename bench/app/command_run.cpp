/// superstep run: integrate a case with one or several methods and write the fields.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "bench/app/cli/cli_values.hpp"
#include "bench/app/cli/command_entry.hpp"
#include "bench/app/commands.hpp"
#include "bench/app/loaded_case.hpp"
#include "bench/app/press/press_commands.hpp"
#include "bench/harness/run_check.hpp"
#include "bench/harness/verification.hpp"
#include "bench/host/interrupt.hpp"
#include "bench/measure/run_one.hpp"
#include "bench/output/layered_vtk.hpp"
#include "bench/output/output_folder.hpp"
#include "bench/output/run_files.hpp"
#include "bench/output/vtk_series.hpp"
#include "core/error.hpp"
#include "core/text/quantity.hpp"
#include "core/text/text_file.hpp"
#include "integrators/method_spec.hpp"

namespace superstep {
namespace {

std::vector<MethodSpec> specs_of(const RunCommand& command) {
  std::vector<MethodSpec> specs(command.integrators.begin(), command.integrators.end());
  if (specs.empty()) specs = {"auto"};
  if (command.tolerance)
    for (auto& spec : specs) spec = spec.with_tolerance(*command.tolerance);
  return specs;
}

// One folder for one SPEC, else one below it for each; equal names get a number.
std::vector<std::string> folders_of(const std::string& out, const std::vector<MethodSpec>& specs) {
  if (specs.size() == 1) return {out};
  std::vector<std::string> folders;
  std::map<std::string, int> seen;
  for (const auto& spec : specs) {
    const std::string name = folder_name(spec.text());
    const int count = ++seen[name];
    folders.push_back(fmt::format("{}/{}{}", out, name, count > 1 ? fmt::format("-{}", count) : ""));
  }
  return folders;
}

struct FinishedRun {
  RunResult result;
  std::optional<RunCheck> check;
  std::vector<std::vector<double>> states;  ///< at output times, where they are to be verified
  std::vector<double> final_state;
};

FinishedRun integrate(const Scene& scene, const ProbeSet& probes, const MethodSpec& spec, Progress& progress,
                      VtkSeries* vtk, const RunCommand& command) {
  FinishedRun run;
  const bool verified = command.verify;
  RunRequest request{
      .probes = &probes, .stop = &stop_flag(), .progress = &progress, .limits = command.limits};
  request.observe = [&](std::size_t output, double t, std::span<const double> state) {
    if (vtk) vtk->add(t, state);
    if (verified) run.states.emplace_back(state.begin(), state.end());
    if (output + 1 == scene.output_times.size()) run.final_state.assign(state.begin(), state.end());
  };
  if (vtk) request.frames = vtk->folder_of_pieces();
  request.write_frame = write_layered_frame;
  request.watches_range = true;
  progress.begin(spec.text(), scene.t_end);
  run.result = run_one(scene, spec, request);
  progress.end();
  if (run.result.outcome.ok()) judge_range(scene, run.result, run.result.outcome);
  if (verified && run.result.outcome.ok()) {
    run.check = check_run(scene, spec, run.result, run.states, stop_flag(), progress, command.limits);
    run.result.outcome = judge_check(scene, *run.check);
  }
  return run;
}

/// What is known of the error: what `--verify` found, else the bound of a method that has one. One that is
/// far above the tolerance does not prove that this was kept.
///   rtol  of the method; 0 = it takes none
std::string error_text(const Scene& scene, double rtol, const RunResult& run,
                       const std::optional<RunCheck>& check) {
  if (check && !check->outcome.ok())
    return fmt::format(" (not verified: {}: {})", check->spec, check->outcome.reason);
  std::string out;
  const auto fields = scene.rhs->fields();
  for (std::size_t f = 0; check && f < check->distance.size(); ++f) {
    out += fmt::format("{}{} within {:.2g} {} rms of {}", f > 0 ? ", " : " (", fields[f].name,
                       check->distance[f], fields[f].unit, check->spec);
    if (check->delivered[f]) out += fmt::format(", {:.2g} of the tolerance", *check->delivered[f]);
  }
  if (check) return out + ")";
  const double bound = run.statistics.error_bound;
  constexpr double far = 2;  // bounds are a little larger than the tolerance that they are made for
  if (bound > 0 && rtol > 0 && bound > far * rtol)
    return fmt::format(" (not verified; proven: its error is at most {:.1e} of the span)", bound);
  if (bound > 0) return fmt::format(" (proven: its error is below {:.1e} of the span)", bound);
  return " (not verified)";
}

std::string summary(const Scene& scene, const MethodSpec& method, const RunResult& run,
                    const std::optional<RunCheck>& check, const std::string& folder) {
  const std::string& spec = method.text();
  if (!run.outcome.ok())
    return fmt::format("{}: {}: {}\n", spec, status_name(run.outcome.status), run.outcome.reason);
  const std::string choice = run.choice.empty() ? "" : fmt::format("  {}\n", run.choice);
  return fmt::format("{}: ok{}, {}, {}, {:.3g} s CPU; {}\n{}", spec,
                     error_text(scene, method.rtol(), run, check), quantity(run.statistics.steps, "step"),
                     quantity(run.sweeps, "sweep"), run.cpu_pilot + run.cpu_prepare + run.cpu_stepping,
                     folder, choice);
}

/// Where the states are that a case with several output times asks for; empty where they are all kept.
std::string kept_states(const Scene& scene, bool vtk) {
  if (vtk || !scene.own_output_times || scene.output_times.size() < 2) return {};
  return fmt::format(
      "of the states at {} output times final.csv keeps the last; {}the Python module hands out all",
      scene.output_times.size(), scene.has_places() ? "--vtk writes all, and " : "");
}

Command run_from_line(const Arguments& values) {
  RunCommand command{.common = common_options(values),
                     .case_file = single_case(values, "run"),
                     .integrators = values.integrators,
                     .tolerance = std::nullopt,
                     .out = values.out,
                     .verify = values.verify,
                     .vtk = values.vtk,
                     .checkpoint = std::nullopt,
                     .export_packing = values.export_packing,
                     .restart = values.restart,
                     .limits = run_limits(values, 0)};
  if (!values.tolerance.empty()) command.tolerance = parse_positive_option("--tolerance", values.tolerance);
  if (!values.checkpoint.empty())
    command.checkpoint = parse_positive_option("--checkpoint", values.checkpoint);
  return command;
}

/// Documents as one, a list.
std::string json_list(const std::vector<std::string>& documents) {
  std::string out = "[";
  for (const auto& document : documents)
    out += fmt::format("{}\n{}", out == "[" ? "" : ",", trimmed(document));
  return out + "\n]\n";
}

int run_scene(const RunCommand& command, const Scene& scene, double cpu_setup) {
  if (command.checkpoint || !command.restart.empty() || !command.export_packing.empty())
    throw UsageError(
        "run: --checkpoint, --restart and --export-packing need a case with moving particles ([dynamics])");
  if (command.vtk) require_packing(scene, "--vtk");
  const auto specs = specs_of(command);
  const auto folders =
      folders_of(command.out.empty() ? default_output_folder(scene.name) : command.out, specs);
  const std::vector<OutputFolder> locked(folders.begin(), folders.end());
  const bool quiet = command.common.quiet;
  if (!quiet) warn(scene.warnings);
  if (const std::string where = kept_states(scene, command.vtk); !quiet && !where.empty()) note(where);
  catch_interrupts();

  Progress progress(!quiet && stderr_is_terminal());
  const ProbeSet probes(scene);
  bool all_ok = true;
  DataInBetween data;
  std::vector<std::string> documents;  // as run.json has them
  for (std::size_t k = 0; k < specs.size() && !stop_flag(); ++k) {
    std::optional<VtkSeries> vtk;
    begin_run_files(folders[k]);
    remove_files_of_motion(folders[k]);
    if (command.vtk)
      vtk.emplace(scene, folders[k]);
    else
      remove_vtk_series(folders[k]);
    const FinishedRun run = integrate(scene, probes, specs[k], progress, vtk ? &*vtk : nullptr, command);
    RunRecord record = record_run(scene, specs[k], run.result, run.final_state);
    record.cpu_setup = cpu_setup;
    record.threads = command.common.threads;
    if (run.check) add_check(*run.check, record);
    if (vtk) record.files = vtk->finish();
    const std::string json = write_run_files(folders[k], scene, probes, run.result, run.final_state, record);
    if (command.common.json)
      documents.push_back(json);
    else if (!quiet || !run.result.outcome.ok())
      data.print(summary(scene, specs[k], run.result, run.check, folders[k]));
    all_ok = all_ok && run.result.outcome.ok();
  }
  if (command.common.json && !documents.empty())
    data.print(specs.size() == 1 ? documents.front() : json_list(documents));
  data.end();
  if (stop_flag()) return interrupted_exit_code();
  return static_cast<int>(all_ok ? ExitCode::ok : ExitCode::numerical);
}

}  // namespace

int execute(const RunCommand& command) {
  check_specs_of_press(command.integrators);
  // What verifies a run looks at all fields at once.
  const LoadedCase one = command.verify ? load_checked_case(command.case_file, command.common.quiet)
                                        : load_case_to_run(command.case_file, command.common.quiet);
  if (const auto* press = std::get_if<Press>(&one.content)) return run_press(command, *press, one.cpu_setup);
  return run_scene(command, std::get<Scene>(one.content), one.cpu_setup);
}

CommandEntry run_command() {
  return {
      .name = "run",
      .does = "integrate a case and write its fields",
      .examples =
          "  superstep run cases/nial_thermal.toml --tolerance 1e-3\n"
          "  superstep run cases/nial_thermal.toml --integrator sts:n=20,nu=1e-3 --out result\n"
          "  superstep run cases/nial_thermal.toml --integrator cvode --tolerance 1e-7\n"
          "  superstep run cases/nial_thermal.toml --vtk --out result   (then open "
          "result/vtk/particles.pvd)\n"
          "  superstep run cases/sintering_example.toml --out result --time-limit 2   (stops, with a "
          "checkpoint)\n"
          "  superstep run cases/sintering_example.toml --out result --restart result/checkpoint.bin\n"
          "  superstep run cases/sintering_example.toml --export-packing pressed.csv",
      .positional = "CASE",
      .positional_meaning = "case file (TOML)",
      .options =
          {integrator_option("auto"),
           {"--tolerance", &Arguments::tolerance,
            "error allowed relative to the field's span, instead of the SPEC's rtol; of moving particles: "
            "change "
            "in the last iteration of a step (without a thermal_integrator), which bounds no error",
            "X"},
           {"--out", &Arguments::out, "folder for final.csv, probes.csv, run.json", "DIR"},
           {"--verify", &Arguments::verify,
            "run again by a method of another family, ten times tighter, and print the error delivered", ""},
           time_limit_option("none"),
           max_work_option(),
           {"--vtk", &Arguments::vtk, "write particles and contacts at every output time for ParaView", ""},
           {"--checkpoint", &Arguments::checkpoint,
            "moving particles: simulated time [s] between writes of DIR/checkpoint.bin", "T"},
           {"--restart", &Arguments::restart, "moving particles: go on from this checkpoint", "FILE"},
           {"--export-packing", &Arguments::export_packing,
            "moving particles: write where they end as a packing, with necks, state and bonds beside it",
            "FILE"}},
      .make = run_from_line};
}

}  // namespace superstep
