/// superstep bench: a press with moving particles.

#include <fmt/format.h>

#include "bench/app/commands.hpp"
#include "bench/app/loaded_case.hpp"
#include "bench/host/interrupt.hpp"
#include "bench/host/machine.hpp"
#include "bench/output/output_folder.hpp"
#include "bench/output/thermal_lanes.hpp"
#include "bench/press/motion_schemes.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/stopwatch.hpp"
#include "results/results_csv.hpp"
#include "results/results_json.hpp"
#include "results/results_table.hpp"

namespace superstep {

int bench_sintering(const BenchCommand& command) {
  check_specs(command.harness.integrators);
  HarnessOptions options = command.harness;
  // Between contact updates the network is linear and constant: the exponential is exact there, whereas the
  // small errors of a method that starts anew after every update add up.
  if (options.reference.empty()) options.reference = "exponential:basis=chebyshev,rtol=1e-12";
  if (options.reference != "none") check_specs({options.reference});
  const double begin = process_cpu_seconds();
  const auto one = dynamics::load_sintering_case(command.case_files.front());
  const double cpu_setup = process_cpu_seconds() - begin;
  const std::string folder = command.out.empty() ? default_output_folder(one.name) : command.out;
  const OutputFolder locked(folder);
  const bool quiet = command.common.quiet;
  Progress progress(!quiet && stderr_is_terminal());
  options.threads = command.common.threads;
  options.stop = &stop_flag();
  catch_interrupts();

  BenchReport report{.version = program_version(),
                     .revision = program_revision(),
                     .machine = machine_facts(),
                     .libraries = library_facts(),
                     .repetitions = options.repetitions,
                     .threads = options.threads,
                     .interrupted = false,
                     .cases = {bench_thermal_lanes(one, options, progress)}};
  BenchCase& thermal = report.cases.front();
  thermal.cpu_setup = cpu_setup;
  report.interrupted = stop_flag();
  remove_stale_file(folder + "/results.json");  // it speaks for the others: gone first
  write_file_atomically(folder + "/results.csv", results_csv(report.cases));
  write_file_atomically(folder + "/results.json", results_json(report));
  if (!quiet) warn(thermal.warnings);
  if (command.common.json)
    print_data(results_json(report));
  else
    print_data(results_table(thermal, options.repetitions, options.threads, use_color(command.common.color)));
  if (one.motion_window && !report.interrupted) {
    const MotionComparison motion = compare_motion_schemes(one, progress);
    write_file_atomically(folder + "/motion.csv", motion_csv(one, motion));
    if (!command.common.json) print_data(fmt::format("\n{}", motion_table(motion)));
  }
  if (!quiet) note(fmt::format("results in {}", folder));
  if (report.interrupted) return interrupted_exit_code;
  for (const auto& row : thermal.rows)
    if (row.ok()) return static_cast<int>(ExitCode::ok);
  return static_cast<int>(ExitCode::numerical);
}

}  // namespace superstep
