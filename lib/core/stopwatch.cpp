#include "core/stopwatch.hpp"

#include <sys/resource.h>
#include <time.h>

namespace superstep {
namespace {

double read_clock(clockid_t clock) noexcept {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double process_cpu_seconds() noexcept {
  return read_clock(CLOCK_PROCESS_CPUTIME_ID);
}

double wall_seconds() noexcept {
  return read_clock(CLOCK_MONOTONIC);
}

double peak_memory_megabytes() noexcept {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e6;  // Linux counts in KiB
}

}  // namespace superstep
