/// superstep bench: the motion of a press.

#include <fmt/format.h>

#include "bench/app/press/press_commands.hpp"
#include "bench/press/motion_schemes.hpp"
#include "bench/press/press_table.hpp"
#include "core/atomic_file.hpp"

namespace superstep {

void bench_motion(const BenchCommand& command, const Press& press, const std::string& folder,
                  Progress& progress) {
  if (!press.motion_window) return;
  const MotionComparison motion = compare_motion_schemes(press, progress);
  write_file_atomically(folder + "/motion.csv", motion_csv(press, motion));
  if (!command.common.json) print_data(fmt::format("\n{}", motion_table(motion)));
}

void bench_press_table(const BenchCommand& command, const Press& press, const std::string& folder,
                       Progress& progress) {
  const auto rows = press_table(press, progress);
  const std::string csv = press_table_csv(press, rows);
  write_file_atomically(folder + "/press_table.csv", csv);
  write_file_atomically(folder + "/press_table.svg", press_table_svg(rows));
  print_data(command.common.json ? csv : press_table_text(rows));
  if (!command.common.quiet)
    note(fmt::format("table in {0}/press_table.csv, heat map in {0}/press_table.svg", folder));
}

}  // namespace superstep
