/// superstep bench: every integrator of a case against the reference and the baseline.

#include <fmt/format.h>

#include <filesystem>

#include "bench/app/cli/cli_values.hpp"
#include "bench/app/cli/command_entry.hpp"
#include "bench/app/commands.hpp"
#include "bench/app/loaded_case.hpp"
#include "bench/app/observation_files.hpp"
#include "bench/app/press/press_commands.hpp"
#include "bench/app/report_file.hpp"
#include "bench/harness/instructions.hpp"
#include "bench/host/interrupt.hpp"
#include "bench/host/machine.hpp"
#include "bench/output/output_folder.hpp"
#include "bench/press/thermal_lanes.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "reports/html/published.hpp"
#include "results/results_csv.hpp"
#include "results/results_json.hpp"
#include "results/results_table.hpp"

namespace superstep {
namespace {

void require_options_of_press(const BenchCommand& command, const std::string& file) {
  if (command.case_files.size() > 1)
    throw UsageError("bench: a case with moving particles ([dynamics]) is measured on its own");
  const GivenOption still[] = {{command.harness.limits.sweeps > 0, "--max-work"},
                               {command.harness.count_instructions, "--instructions"}};
  refuse_for_moving("bench", still, file);
}

std::vector<LoadedCase> load_all(const BenchCommand& command) {
  check_specs(command.harness.integrators);
  const auto& reference = command.harness.reference;
  if (!reference.empty() && reference != "none") check_specs({reference});
  std::vector<LoadedCase> cases;
  require_distinct_names(command.case_files);
  for (const auto& file : command.case_files) {
    cases.push_back(load_bench_case(file, command.common.quiet));
    if (!command.press_table && std::holds_alternative<Press>(cases.back().content))
      require_options_of_press(command, file);
  }
  return cases;
}

std::string output_folder(const BenchCommand& command, const std::vector<LoadedCase>& cases) {
  if (!command.out.empty()) return command.out;
  return default_output_folder(cases.size() == 1 ? cases.front().head().name : "bench");
}

/// results.json speaks for the others: it is gone before the first of them changes, and written last.
void write_results(const std::string& folder, const BenchReport& report,
                   const std::vector<LoadedCase>& cases) {
  remove_stale_file(folder + "/results.json");
  write_file_atomically(folder + "/results.csv", results_csv(report.cases));
  if (report.interrupted)
    remove_observation_files(folder);  // of the benchmark before
  else
    write_observation_files(folder, report, cases);
  write_file_atomically(folder + "/results.json", results_json(report));
}

BenchCase measure(const Scene& scene, double cpu_setup, HarnessOptions options, Progress& progress) {
  options.sampled = published_measure(scene.source);
  return bench_case(scene, cpu_setup, options, progress);
}

BenchCase measure(const Press& press, double cpu_setup, const HarnessOptions& options, Progress& progress) {
  return bench_thermal_lanes(press, cpu_setup, options, progress);
}

ExitCode exit_code(const BenchReport& report) {
  bool measured = false;
  for (const auto& one : report.cases)
    for (const auto& row : one.rows) {
      if (row.ok()) return ExitCode::ok;
      measured = measured || row.status != status_name(Status::refused);
    }
  return measured ? ExitCode::numerical : ExitCode::inconclusive;
}

BenchReport empty_report(const BenchCommand& command) {
  return {.version = program_version(),
          .revision = program_revision(),
          .machine = machine_facts(),
          .libraries = library_facts(),
          .repetitions = command.harness.repetitions,
          .threads = command.common.threads,
          .interrupted = false,
          .cases = {}};
}

int repetitions_of(const Arguments& values, int fallback) {
  if (!values.repetitions) return fallback;
  return static_cast<int>(parse_integer_option("--repetitions", *values.repetitions, 1, 10000));
}

/// What both kinds of benchmark take from the line.
template <class Benchmark, class Options>
void take(const Arguments& values, Benchmark& command, Options& options, int repetitions) {
  command.common = common_options(values);
  command.case_files = values.cases;
  command.out = values.out;
  command.report = values.report;
  options.integrators = values.integrators;
  options.reference = values.reference;
  options.use_cache = !values.no_cache;
  options.repetitions = repetitions_of(values, repetitions);
  options.limits = run_limits(values, usual_time_limit);
}

/// Throws UsageError for an option that a special kind of benchmark would ignore.
void refuse_beside(const char* kind, std::span<const GivenOption> options) {
  refuse_given("bench", options, fmt::format("does not go with {}; leave one of them out", kind));
}

Command make_work_precision(const Arguments& values) {
  const GivenOption foreign[] = {{values.json, "--json"},
                                 {values.instructions, "--instructions"},
                                 {values.press_table, "--press-table"}};
  refuse_beside("--work-precision", foreign);
  if (values.reference == "none")
    throw UsageError("bench: --work-precision needs a reference; leave --reference none out");
  WorkPrecisionCommand command;
  take(values, command, command.options, 1);
  return command;
}

Command make_corpus(const Arguments& values) {
  const GivenOption foreign[] = {
      {!values.cases.empty(), "a case file"},     {values.work_precision, "--work-precision"},
      {!values.reference.empty(), "--reference"}, {values.json, "--json"},
      {values.instructions, "--instructions"},    {values.press_table, "--press-table"}};
  refuse_beside("--corpus", foreign);
  CorpusCommand command;
  command.common = common_options(values);
  command.corpus = values.corpus;
  command.out = values.out;
  command.report = values.report;
  command.markdown = values.markdown;
  command.options.integrators = values.integrators;
  command.options.use_cache = !values.no_cache;
  command.options.repetitions = repetitions_of(values, command.options.repetitions);
  command.options.limits = run_limits(values, 0);
  command.options.limits.say = {};
  return command;
}

/// A table of presses runs each of them as its case says.
void require_options_of_press_table(const Arguments& values) {
  const GivenOption foreign[] = {{!values.integrators.empty(), "--integrator"},
                                 {values.repetitions.has_value(), "--repetitions"},
                                 {!values.reference.empty(), "--reference"},
                                 {!values.time_limit.empty(), "--time-limit"},
                                 {!values.max_work.empty(), "--max-work"},
                                 {values.instructions, "--instructions"},
                                 {values.no_cache, "--no-cache"}};
  refuse_beside("--press-table", foreign);
}

Command bench_from_line(const Arguments& values) {
  if (!values.corpus.empty()) return make_corpus(values);
  if (values.markdown) throw UsageError("bench: --markdown goes with --corpus; leave it out, or give both");
  if (values.cases.empty()) throw UsageError("bench: a case file is missing; see superstep bench --help");
  if (values.work_precision) return make_work_precision(values);
  if (values.press_table) require_options_of_press_table(values);
  BenchCommand command;
  command.press_table = values.press_table;
  take(values, command, command.harness, command.harness.repetitions);
  command.harness.count_instructions = values.instructions;
  return command;
}

}  // namespace

int execute(const BenchCommand& command) {
  if (command.harness.count_instructions && valgrind_version().empty())
    throw UsageError("bench: --instructions needs Valgrind; install it (apt-get install valgrind)");
  const auto cases = load_all(command);
  const std::string folder = output_folder(command, cases);
  const OutputFolder locked(folder);
  if (command.press_table) return bench_press_tables(command, cases, folder);
  const bool quiet = command.common.quiet;
  Progress progress(!quiet && stderr_is_terminal());
  HarnessOptions options = command.harness;
  options.threads = command.common.threads;
  options.stop = &stop_flag();
  catch_interrupts();

  BenchReport report = empty_report(command);
  DataInBetween data;
  if (options.count_instructions) report.machine.push_back({"callgrind", counter_facts()});
  for (const auto& one : cases) {
    if (stop_flag()) break;
    report.cases.push_back(
        std::visit([&](const auto& content) { return measure(content, one.cpu_setup, options, progress); },
                   one.content));
    const BenchCase& done = report.cases.back();
    if (!quiet) warn(done.warnings);
    if (command.common.json) continue;
    if (report.cases.size() > 1) data.print("\n");
    data.print(results_table(done, options.repetitions, options.threads, use_color(command.common.color)));
  }
  report.interrupted = stop_flag();
  write_results(folder, report, cases);
  if (command.common.json) data.print(results_json(report));
  for (const auto& one : cases)
    if (const auto* press = std::get_if<Press>(&one.content); press && !report.interrupted)
      bench_motion(command, *press, folder, progress);
  if (!quiet && report.interrupted) note("interrupted: only what had been measured by then is written");
  if (!quiet) note(fmt::format("results in {0}/results.csv and {0}/results.json", folder));
  renew_report(folder, command.report, quiet);
  data.end();
  if (report.interrupted) return interrupted_exit_code();
  return static_cast<int>(exit_code(report));
}

CommandEntry bench_command() {
  return {
      .name = "bench",
      .does = "measure integrators on a case: CPU time, speedup, error",
      .examples =
          "  superstep bench cases/nial_thermal.toml\n"
          "  superstep bench cases/nial_thermal.toml --integrator sts:n=20,nu=1e-3 --repetitions 5\n"
          "  superstep bench cases/nial_thermal.toml --work-precision\n"
          "  superstep bench --corpus quick --report\n"
          "  superstep bench cases/nial_thermal.toml --reference forward-euler --json",
      .positional = "CASE",
      .positional_meaning = "case files (TOML)",
      .options =
          {integrator_option("those of the case, else every family"),
           {"--repetitions", &Arguments::repetitions,
            "timed runs of each integrator (default 3; 1 with --work-precision)", "N"},
           {"--out", &Arguments::out, "folder for results.csv and results.json", "DIR"},
           {"--reference", &Arguments::reference,
            "method that errors are measured against, or none (default: the exponential where it is exact, "
            "else CVODE; each checked by a method of another family)",
            "SPEC"},
           time_limit_option(fmt::format("{:g}", usual_time_limit)),
           max_work_option(),
           {"--instructions", &Arguments::instructions,
            "count the instructions of each method's stepping as well, under Valgrind", ""},
           {"--work-precision", &Arguments::work_precision,
            "sweep every method over tolerances and steps, or take the SPECs that are given; say who is "
            "fastest at "
            "each error",
            ""},
           {"--corpus", &Arguments::corpus,
            "every method over its ladder on a set of scenes: quick, standard (default), large, or a folder "
            "of cases; what was measured before is not measured again",
            "SET", "standard"},
           {"--markdown", &Arguments::markdown, "with --corpus: tables in Markdown", ""},
           {"--press-table", &Arguments::press_table,
            "moving particles: springback over hold and densification, with its spread over seeds", ""},
           {"--report", &Arguments::report, "write report.html beside the results as well", ""},
           {"--no-cache", &Arguments::no_cache, "neither read nor write cached references", ""}},
      .takes = {.least = 0, .most = 0},
      .make = bench_from_line};
}

}  // namespace superstep
