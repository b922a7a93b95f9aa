/// superstep bench: the motion of a press.

#include <fmt/format.h>

#include "bench/app/press/press_commands.hpp"
#include "bench/press/motion_schemes.hpp"
#include "core/atomic_file.hpp"

namespace superstep {

void bench_motion(const BenchCommand& command, const Press& press, const std::string& folder,
                  Progress& progress) {
  if (!press.motion_window) return;
  const MotionComparison motion = compare_motion_schemes(press, progress);
  write_file_atomically(folder + "/motion.csv", motion_csv(press, motion));
  if (!command.common.json) print_data(fmt::format("\n{}", motion_table(motion)));
}

}  // namespace superstep
