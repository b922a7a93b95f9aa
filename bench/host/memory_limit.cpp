#include "bench/host/memory_limit.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

namespace superstep {
namespace {

constexpr std::uint64_t kilobyte = 1024;
constexpr auto any = std::numeric_limits<std::uint64_t>::max();

/// The number behind `key` in a file with one such pair a line.
std::optional<std::uint64_t> number_of(const char* file, const std::string& key) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string word;
    std::uint64_t number = 0;
    if (words >> word >> number && word == key) return number;
  }
  return std::nullopt;
}

/// The smallest limit from `group` up to the root of its tree; files without a number set none.
std::uint64_t limit_of_group(const std::string& tree, std::string group, const char* file) {
  std::uint64_t least = any, limit = 0;
  for (;; group.erase(group.find_last_of('/'))) {
    if (std::ifstream stream(tree + group + "/" + file); stream >> limit) least = std::min(least, limit);
    if (group.find('/') == std::string::npos) return least;
  }
}

/// Of both versions of control groups; lines are as in "4:memory:/job" and "0::/job".
std::uint64_t limit_of_groups() {
  std::ifstream stream("/proc/self/cgroup");
  std::uint64_t least = any;
  for (std::string line; std::getline(stream, line);) {
    const auto first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1),
                      group = line.substr(second + 1);
    if (controllers == "memory")
      least = std::min(least, limit_of_group("/sys/fs/cgroup/memory", group, "memory.limit_in_bytes"));
    if (controllers.empty()) least = std::min(least, limit_of_group("/sys/fs/cgroup", group, "memory.max"));
  }
  return least;
}

}  // namespace

std::uint64_t attainable_memory() {
  const auto free = number_of("/proc/meminfo", "MemAvailable:"),
             swap = number_of("/proc/meminfo", "SwapFree:");
  return std::min(free ? (*free + swap.value_or(0)) * kilobyte : any, limit_of_groups());
}

void keep_to_memory(std::uint64_t bytes) {
  // BLAS reserves a buffer for each of its threads, sanitizers terabytes, which they hardly use.
  const auto reserved = number_of("/proc/self/status", "VmData:");
  rlimit limit{};
  if (bytes == any || !reserved || getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_cur, *reserved * kilobyte + bytes);
  setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace superstep
