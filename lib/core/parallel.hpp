#pragma once
/// Threads over index ranges. Nothing that is computed depends on how many there are.

#include <omp.h>

#include <algorithm>
#include <cstddef>

namespace superstep {

/// Below so many entries the start of a team costs more than it saves (a few microseconds against one).
constexpr std::size_t smallest_parallel_range = 4096;

/// Threads that a loop over `work` entries takes.
[[nodiscard]] inline std::size_t threads_for(std::size_t work) noexcept {
  if (work < smallest_parallel_range || omp_in_parallel()) return 1;
  return static_cast<std::size_t>(omp_get_max_threads());
}

/// Calls body(first, last) for ranges that cover [0, count), each thread always the same one: what a thread
/// touched first stays its own.
///   work  entries that the whole loop handles; decides whether threads pay
template <class Body>
void for_ranges(std::size_t count, std::size_t work, const Body& body) {
  if (threads_for(work) == 1) {
    body(std::size_t{0}, count);
    return;
  }
#pragma omp parallel
  {
    const auto threads = static_cast<std::size_t>(omp_get_num_threads());
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    const std::size_t share = count / threads, rest = count % threads;
    const std::size_t first = thread * share + std::min(thread, rest);
    body(first, first + share + (thread < rest ? 1 : 0));
  }
}

/// Calls body(i) for every i of [0, count); the iterations must be independent.
template <class Body>
void for_each_entry(std::size_t count, const Body& body) {
  for_ranges(count, count, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) body(i);
  });
}

}  // namespace superstep
