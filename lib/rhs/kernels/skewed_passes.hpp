#pragma once
/// Several passes over rows in one go, so that what one pass reads from memory the next finds in the cache.
///
///   Rows of pass k need those of pass k-1 up to `reach` rows away. Each pass works on a block of rows that
///   lies `skew` behind the block of the pass before; then all blocks, a front, move on by one block:
///     pass 0              [ block ]
///     pass 1      [ block ]
///   With one thread a skew of `reach` is enough, the passes of a front being done in turn. Threads do the
///   blocks of a front at the same time, which takes a skew of one block more.
/// Sources: wavefront temporal blocking, Wellein, Hager, Zeiser, Wittmann & Fehske (2009),
/// doi:10.1109/COMPSAC.2009.82; for sparse matrices Alappat, Hager, Schenk & Wellein (2023),
/// doi:10.1109/TPDS.2022.3223512. Here the bandwidth of the reordered matrix is all that counts.

#include <omp.h>

#include <algorithm>
#include <cstddef>

namespace superstep {

struct SkewedBlocks {
  SkewedBlocks(std::size_t row_count, std::size_t reach, std::size_t smallest_block, std::size_t thread_count)
      : rows(row_count),
        block(std::max(reach, smallest_block)),
        threads(thread_count),
        skew(threads == 1 ? reach : reach + block) {}

  std::size_t rows, block, threads, skew;

  /// Rows that pass between the first touch of the first pass and the last touch of the last one.
  [[nodiscard]] std::size_t rows_in_flight(std::size_t passes) const noexcept {
    return passes * skew + block;
  }
  /// Row at `offset` in the block of a pass.
  [[nodiscard]] std::size_t row(std::size_t front, std::size_t pass, std::size_t offset) const noexcept {
    const std::size_t ahead = front + offset, behind = pass * skew;
    return std::min(rows, ahead > behind ? ahead - behind : 0);
  }
};

/// Calls for every block of every pass, in an order that respects `reach` both ways (a row is written over
/// only after all that read it):
///   work(pass, first, last)   rows of the block, perhaps in several parts by several threads
///   watch(pass, first, last)  all rows of the block by one thread, in ascending order, while results of the
///                             pass before are still there
template <class Work, class Watch>
void skewed_passes(const SkewedBlocks& blocks, std::size_t passes, const Work& work, const Watch& watch) {
  const std::size_t end = blocks.rows + (passes - 1) * blocks.skew;
  const auto in_rows = [&](const auto& call, std::size_t front, std::size_t pass, std::size_t from,
                           std::size_t to) {
    const std::size_t first = blocks.row(front, pass, from), last = blocks.row(front, pass, to);
    if (first < last) call(pass, first, last);
  };
  // The blocks of a front laid end to end are shared out evenly.
  const auto take_part = [&](std::size_t thread, std::size_t team) {
    const std::size_t share = (passes * blocks.block + team - 1) / team;
    for (std::size_t front = 0; front < end; front += blocks.block) {
      for (std::size_t pass = 0; pass < passes; ++pass) {
        if (thread == 0) in_rows(watch, front, pass, 0, blocks.block);
        const auto own = [&](std::size_t position) {
          const std::size_t begin = pass * blocks.block;
          return std::clamp(position, begin, begin + blocks.block) - begin;
        };
        in_rows(work, front, pass, own(thread * share), own((thread + 1) * share));
      }
      if (team > 1) {
#pragma omp barrier
      }
    }
  };
  if (blocks.threads == 1) {
    take_part(0, 1);
    return;
  }
  const auto wanted = static_cast<int>(blocks.threads);
#pragma omp parallel num_threads(wanted)
  take_part(static_cast<std::size_t>(omp_get_thread_num()), static_cast<std::size_t>(omp_get_num_threads()));
}

}  // namespace superstep
