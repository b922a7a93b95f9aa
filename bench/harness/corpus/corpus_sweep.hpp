#pragma once
/// The ladders of all methods over one scene of a corpus: every SPEC once, for its error, its memory and
/// whether it ends at all; those near the front again, in rounds that take turns.

#include <atomic>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bench/host/progress.hpp"
#include "bench/measure/run_limits.hpp"
#include "case/corpus/corpus_tags.hpp"
#include "case/scene.hpp"
#include "results/corpus/corpus_row.hpp"

namespace superstep {

struct CorpusOptions {
  std::vector<std::string>
      integrators;        ///< SPECs, or names that stand for their ladders; empty = all ladders
  bool use_cache = true;  ///< of references
  int repetitions = 3;    ///< rounds of those near the front
  int threads = 1;
  RunLimits limits;  ///< of each run
  const std::atomic<bool>* stop = nullptr;
};

/// SPECs of the ladders, each ladder from loose to tight. Throws UsageError.
[[nodiscard]] std::vector<std::string> corpus_specs(const std::vector<std::string>& asked);

/// Names scene, build and machine.
[[nodiscard]] std::string corpus_key(const Scene& scene, int threads);

/// Called with what is there so far, so that it is not lost.
using KeepRows = std::function<void(const std::vector<CorpusRow>& rows)>;

/// Rows of one scene. Rows of `known` that have the same key are taken over; what they lack is measured.
[[nodiscard]] std::vector<CorpusRow> sweep_scene(const Scene& scene, const CorpusTags& tags,
                                                 const CorpusOptions& options,
                                                 std::span<const CorpusRow> known, const KeepRows& keep,
                                                 Progress& progress);

}  // namespace superstep
