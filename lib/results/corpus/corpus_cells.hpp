#pragma once
/// Who is fastest on which scene at which error, and how sure that is.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "results/corpus/corpus_row.hpp"

namespace superstep {

/// Errors below so many error bars of the reference can not be told from each other.
inline constexpr double bars_that_count = 3;

/// The rows of one scene; they belong to whoever holds them.
struct SceneRows {
  const CorpusRow* facts = nullptr;  ///< any of them: for what they share
  std::vector<const CorpusRow*> rows;
};

/// Scenes in the order in which they come.
[[nodiscard]] std::vector<SceneRows> scenes_of(std::span<const CorpusRow> rows);

/// Errors over the span at which methods are compared: 1e-2, 1e-4, 1e-6, 1e-8.
[[nodiscard]] std::span<const double> corpus_levels();

/// CPU of one method over that of another, from rounds that took turns.
struct Lead {
  double estimate = 1;       ///< quotient of the medians
  double low = 1, high = 1;  ///< smallest and largest quotient of a round
  /// A lead that counts: in every round, and of a tenth at least.
  [[nodiscard]] bool clear() const noexcept { return low > 1 && estimate >= 1.1; }
};
[[nodiscard]] Lead lead_of(const CorpusRow& slower, const CorpusRow& faster);

/// The cheapest SPEC of one integrator that reaches a level.
struct Entrant {
  const CorpusRow* row = nullptr;
  Lead behind;  ///< its CPU over that of the fastest
};

/// One scene at one level.
struct CorpusCell {
  const CorpusRow* facts = nullptr;
  double level = 0;
  bool judged = true;             ///< false: the reference is known too poorly for this level
  std::vector<Entrant> entrants;  ///< fastest first, one an integrator; without `auto`
  /// The fastest and those that can not be told from it.
  [[nodiscard]] std::size_t tied() const;
  /// The one fastest integrator; empty where there is none, or where it can not be told.
  [[nodiscard]] std::string winner() const;
};

/// The cheapest row of `scene` that reaches `level`, among those that `eligible` accepts; null = none.
template <class Eligible>
[[nodiscard]] const CorpusRow* cheapest_row(const SceneRows& scene, double level, Eligible eligible) {
  const CorpusRow* best = nullptr;
  for (const CorpusRow* row : scene.rows)
    if (row->ok() && row->cpu && row->error && *row->error <= level && eligible(*row) &&
        (!best || *row->cpu < *best->cpu))
      best = row;
  return best;
}

/// Cells of every scene and level.
[[nodiscard]] std::vector<CorpusCell> corpus_cells(std::span<const SceneRows> scenes);

/// Within a factor of the best [s], or within 2 ms of it where it takes less than 5 ms.
[[nodiscard]] bool close_to_best(double cpu, double best, double factor) noexcept;

/// `auto` at one of its tolerances.
struct Regret {
  const CorpusRow *row = nullptr, *best = nullptr;  ///< null: nobody else met the tolerance
  double rtol = 0;
  double ratio = 0;      ///< CPU of auto over that of the best
  double delivered = 0;  ///< its error over its tolerance
  /// Within a ratio, or within 2 ms where the best takes less than 5 ms.
  [[nodiscard]] bool within(double limit) const;
};
[[nodiscard]] std::vector<Regret> regrets_of(std::span<const SceneRows> scenes);

/// How many cells two measurements of a corpus judge alike.
struct CellAgreement {
  std::size_t cells = 0, same = 0, untold = 0, different = 0;
  std::vector<std::string> differences;  ///< "scene at 1e-4: rkc, rock"
};
[[nodiscard]] CellAgreement agreement(std::span<const CorpusCell> a, std::span<const CorpusCell> b);

}  // namespace superstep
