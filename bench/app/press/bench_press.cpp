/// superstep bench: the motion of a press.

#include <fmt/format.h>

#include <algorithm>

#include "bench/app/press/press_commands.hpp"
#include "bench/app/report_file.hpp"
#include "bench/host/interrupt.hpp"
#include "bench/press/motion_schemes.hpp"
#include "bench/press/press_table.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "results/press/press_table_text.hpp"

namespace superstep {

void bench_motion(const BenchCommand& command, const Press& press, const std::string& folder,
                  Progress& progress) {
  if (!press.motion_window) return;
  const MotionComparison motion = compare_motion_schemes(press, progress);
  write_file_atomically(folder + "/motion.csv", motion_csv(press, motion));
  if (!command.common.json) print_data(fmt::format("\n{}", motion_table(motion)));
}

int bench_press_tables(const BenchCommand& command, const std::vector<LoadedCase>& cases,
                       const std::string& folder) {
  catch_interrupts();
  const bool quiet = command.common.quiet;
  Progress progress(!quiet && stderr_is_terminal());
  std::vector<PressTableRow> rows;
  for (const auto& one : cases) {
    const auto* press = std::get_if<Press>(&one.content);
    if (!press) throw UsageError("bench: --press-table needs cases with moving particles ([dynamics])");
    const auto own = press_table(*press, &stop_flag(), progress);
    rows.insert(rows.end(), own.begin(), own.end());
  }
  write_file_atomically(folder + "/press_table.csv", press_table_csv(rows));
  print_data(command.common.json ? press_table_json(rows)
                                 : press_table_text(rows, use_color(command.common.color)));
  if (!quiet) note(fmt::format("table in {}/press_table.csv", folder));
  renew_report(folder, command.report, quiet);
  if (stop_flag()) return interrupted_exit_code();
  const bool any = std::any_of(rows.begin(), rows.end(), [](const auto& row) { return row.ok(); });
  return static_cast<int>(any ? ExitCode::ok : ExitCode::inconclusive);
}

}  // namespace superstep
