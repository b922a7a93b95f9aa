#pragma once
/// What a corpus says about methods: which one for which class, size and error; how often each is how close
/// to the best; what failed.

#include <span>
#include <string>
#include <vector>

#include "results/corpus/corpus_cells.hpp"

namespace superstep {

/// One method over a group of cells.
struct MethodScore {
  std::string integrator;
  std::size_t reached = 0;  ///< cells whose error it reached
  std::size_t alone = 0;    ///< cells that it clearly won
  std::size_t shared = 0;   ///< cells in which it is among those that can not be told apart
  double factor = 0;        ///< geometric mean of its CPU over that of the best, where it reached the error
  double memory = 0;        ///< MB, geometric mean of what it added, where it reached the error
};

/// Cells of one class (or any), one size (or any) and one level.
struct MapCell {
  std::string scene_class, size;  ///< empty = all
  double level = 0;
  std::size_t cells = 0;             ///< whose error somebody reaches
  std::vector<MethodScore> methods;  ///< those that reach it most often first, then the fastest
};

/// "1e3" for 400 to 4000 unknowns: the nearest power of ten.
[[nodiscard]] std::string size_class(std::uint64_t unknowns);

/// By class and level over all sizes, classes in the order in which they come; then by size over all classes.
[[nodiscard]] std::vector<MapCell> corpus_map(std::span<const CorpusCell> cells);

/// Performance profile of one method: the part of all cells in which its CPU is within a factor of the best.
/// Source: Dolan & More (2002), doi:10.1007/s101070100263.
struct Profile {
  std::string integrator;
  std::vector<double> ratios;  ///< ascending, of the cells whose error it reaches
  std::size_t cells = 0;       ///< whose error anybody reaches
  /// The part within `factor` of the best.
  [[nodiscard]] double within(double factor) const;
};
/// Those of all methods, the one that is the best most often first; of one level, or of all where it is 0.
[[nodiscard]] std::vector<Profile> corpus_profiles(std::span<const CorpusCell> cells, double level = 0);

/// Points of one method by what became of them.
struct Tally {
  std::string integrator;
  std::size_t points = 0, ok = 0;
  std::vector<const CorpusRow*> others;  ///< all that are not ok
};
[[nodiscard]] std::vector<Tally> corpus_tallies(std::span<const CorpusRow> rows);

/// What all regrets come to.
struct RegretSummary {
  std::size_t count = 0, close = 0, kept = 0;  ///< judged; within 1.3; tolerance kept
  double worst = 0;                            ///< largest ratio of those that are not within 2, else of all
  bool never_beyond = true;                    ///< all within 2
};
[[nodiscard]] RegretSummary summarize(std::span<const Regret> regrets);

}  // namespace superstep
