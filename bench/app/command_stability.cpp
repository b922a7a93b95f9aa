/// superstep stability: where each method is safe on a case, by theory and by measurement.

#include <optional>

#include "bench/app/cli/command_entry.hpp"
#include "bench/app/commands.hpp"
#include "bench/app/loaded_case.hpp"
#include "bench/host/progress.hpp"
#include "bench/lab/lab.hpp"
#include "bench/output/output_folder.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "reports/text/stability_report.hpp"
#include "results/study/stability_tables.hpp"

namespace superstep {

namespace {

Command stability_from_line(const Arguments& values) {
  return StabilityCommand{.common = common_options(values),
                          .case_file = single_case(values, "stability"),
                          .out = values.out,
                          .quick = values.quick};
}

}  // namespace

int execute(const StabilityCommand& command) {
  std::optional<OutputFolder> locked;
  if (!command.out.empty()) locked.emplace(command.out);
  const Case one = load_case(command.case_file);
  const Scene& scene = scene_of(one, "stability");
  const bool quiet = command.common.quiet;
  if (!quiet) warn(scene.warnings);
  Progress progress(!quiet && stderr_is_terminal());
  const StabilityResults results = run_stability_lab(scene, command.quick, progress);
  if (!command.out.empty()) {
    remove_stale_file(command.out + "/stability.json");  // it speaks for the tables: gone first, written last
    for (const auto& table : stability_tables(results))
      write_file_atomically(command.out + "/" + table.file_name(), table.csv());
    write_file_atomically(command.out + "/stability.json", stability_json(results));
  }
  print_data(command.common.json ? stability_json(results)
                                 : stability_text(results, use_color(command.common.color)));
  if (is_consistent(results)) return static_cast<int>(ExitCode::ok);
  note("theory and measurement differ where they must agree; see the verdicts");
  return static_cast<int>(ExitCode::numerical);
}

CommandEntry stability_command() {
  return {
      .name = "stability",
      .does = "stability laboratory: where each method is safe on a case, and where not",
      .examples =
          "  superstep stability cases/nial_thermal.toml\n"
          "  superstep stability cases/chain.toml --quick\n"
          "  superstep stability cases/lattice_two_way.toml --quick\n"
          "  superstep stability cases/nial_thermal.toml --out result --json",
      .positional = "CASE",
      .positional_meaning = "case file (TOML)",
      .options =
          {{"--out", &Arguments::out,
            "folder for stability_*.csv: methods, critical_step, rounding, sweeps, states (default: none)",
            "DIR"},
           {"--quick", &Arguments::quick, "fewer parameter sets, done in seconds", ""}},
      .make = stability_from_line};
}

}  // namespace superstep
