/// superstep bench: every integrator of a case against the reference and the baseline.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "bench/app/commands.hpp"
#include "bench/app/loaded_case.hpp"
#include "bench/console/interrupt.hpp"
#include "bench/output/machine.hpp"
#include "bench/output/observation_files.hpp"
#include "bench/output/output_folder.hpp"
#include "bench/output/report_file.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "integrators/press/sintering_case.hpp"
#include "reports/html/published.hpp"
#include "results/results_csv.hpp"
#include "results/results_json.hpp"
#include "results/results_table.hpp"

namespace superstep {
namespace {

std::vector<LoadedCase> load_all(const BenchCommand& command) {
  check_specs(command.harness.integrators);
  const auto& reference = command.harness.reference;
  if (!reference.empty() && reference != "none") check_specs({reference});
  std::vector<LoadedCase> cases;
  require_distinct_names(command.case_files);
  for (const auto& file : command.case_files) cases.push_back(load_case(file));
  return cases;
}

std::string output_folder(const BenchCommand& command, const std::vector<LoadedCase>& cases) {
  if (!command.out.empty()) return command.out;
  return default_output_folder(cases.size() == 1 ? cases.front().scene.name : "bench");
}

/// results.json speaks for the others: it is gone before the first of them changes, and written last.
void write_results(const std::string& folder, const BenchReport& report,
                   const std::vector<LoadedCase>& cases) {
  remove_stale_file(folder + "/results.json");
  write_file_atomically(folder + "/results.csv", results_csv(report.cases));
  if (!report.interrupted) write_observation_files(folder, report, cases);
  write_file_atomically(folder + "/results.json", results_json(report));
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

}  // namespace

int execute(const BenchCommand& command) {
  const auto moving = std::count_if(command.case_files.begin(), command.case_files.end(),
                                    [](const auto& file) { return dynamics::is_sintering_case(file); });
  if (moving > 0 && command.case_files.size() > 1)
    throw UsageError("bench: a case with moving particles ([dynamics]) is measured on its own");
  if (moving > 0) return bench_sintering(command);
  const auto cases = load_all(command);
  const std::string folder = output_folder(command, cases);
  const OutputFolder locked(folder);
  const bool quiet = command.common.quiet;
  Progress progress(!quiet && stderr_is_terminal());
  HarnessOptions options = command.harness;
  options.threads = command.common.threads;
  options.stop = &stop_flag();
  catch_interrupts();

  BenchReport report = empty_report(command);
  for (const auto& [scene, cpu_setup] : cases) {
    if (stop_flag()) break;
    options.sampled = published_measure(scene.source);
    report.cases.push_back(bench_case(scene, cpu_setup, options, progress));
    const BenchCase& done = report.cases.back();
    if (!quiet) warn(done.warnings);
    if (command.common.json) continue;
    if (report.cases.size() > 1) print_data("\n");
    print_data(results_table(done, options.repetitions, options.threads, use_color(command.common.color)));
  }
  report.interrupted = stop_flag();
  write_results(folder, report, cases);
  if (command.common.json) print_data(results_json(report));
  if (!quiet) note(fmt::format("results in {0}/results.csv and {0}/results.json", folder));
  if (command.report) {
    const std::string file = write_report(folder);
    if (!quiet) note("report in " + file);
  } else if (std::error_code ignored; !quiet && std::filesystem::exists(folder + "/report.html", ignored)) {
    note(fmt::format("{0}/report.html shows earlier results; renew it with superstep report {0}", folder));
  }
  if (report.interrupted) return interrupted_exit_code;
  return static_cast<int>(exit_code(report));
}

}  // namespace superstep
