/// superstep bench --work-precision: every method over a ladder of tolerances.

#include <fmt/format.h>

#include "bench/app/commands.hpp"
#include "bench/app/loaded_case.hpp"
#include "bench/app/report_file.hpp"
#include "bench/harness/work_precision.hpp"
#include "bench/host/interrupt.hpp"
#include "bench/output/output_folder.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"

namespace superstep {
namespace {

std::string folder_of(const WorkPrecisionCommand& command, const CaseHead& head) {
  if (command.out.empty()) return default_output_folder(head.name);
  return command.case_files.size() == 1 ? command.out : command.out + "/" + head.name;
}

}  // namespace

int execute(const WorkPrecisionCommand& command) {
  check_specs(command.options.integrators);
  if (!command.options.reference.empty()) check_specs({command.options.reference});
  std::vector<LoadedCase> cases;
  require_distinct_names(command.case_files);
  for (const auto& file : command.case_files) {
    cases.push_back(load_bench_case(file));
    (void)scene_of(cases.back().content, "--work-precision");
  }
  std::vector<OutputFolder> locked;
  for (const auto& one : cases) locked.emplace_back(folder_of(command, one.head()));
  Progress progress(!command.common.quiet && stderr_is_terminal());
  WorkPrecisionOptions options = command.options;
  options.threads = command.common.threads;
  options.stop = &stop_flag();
  catch_interrupts();

  bool measured = false;
  DataInBetween data;
  for (const auto& one : cases) {
    if (stop_flag()) break;
    const auto& scene = std::get<Scene>(one.content);
    const WorkPrecision study = work_precision(scene, options, progress);
    for (const auto& point : study.points) measured = measured || point.ok();
    data.print(work_precision_table(study, use_color(command.common.color)));
    const std::string file = folder_of(command, scene) + "/work_precision.csv";
    write_file_atomically(file, work_precision_csv(study));
    if (!command.common.quiet) note("points in " + file);
    renew_report(folder_of(command, scene), command.report, command.common.quiet);
  }
  data.end();
  if (stop_flag()) return interrupted_exit_code();
  return static_cast<int>(measured ? ExitCode::ok : ExitCode::inconclusive);
}

}  // namespace superstep
