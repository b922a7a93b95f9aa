#pragma once
/// Constants of the cost models from the points of a corpus, and what `auto` would have chosen with them.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "integrators/costs/models.hpp"
#include "results/corpus/corpus_cells.hpp"

namespace superstep {

/// A measured run of a family whose cost is modelled.
struct CostPoint {
  const CorpusRow* row = nullptr;
  Family family = Family::rock;
  Work work;
  double rtol = 0;
  double seconds = 0;  ///< CPU; of Euler, that of one step
};

/// Of rows that ended well, on one thread. The rows must outlive them.
[[nodiscard]] std::vector<CostPoint> cost_points(std::span<const CorpusRow> rows);

/// What the rows of a scene say about its work.
[[nodiscard]] Work work_of(const CorpusRow& row);

/// Constants that make the logarithms of predicted and measured times agree, outliers counting less; those
/// that no point says anything about stay what they are without measurements.
[[nodiscard]] CostConstants fit_costs(std::span<const CostPoint> points);

/// How well: of one family, over its points.
struct FitQuality {
  Family family = Family::rock;
  std::size_t points = 0;
  double median = 1, worst = 1;  ///< factor between predicted and measured, either way
};
[[nodiscard]] std::vector<FitQuality> fit_quality(std::span<const CostPoint> points,
                                                  const CostConstants& constants);

/// `auto` at one tolerance on one scene whose class had no part in the fit.
struct HeldOut {
  const CorpusRow* facts = nullptr;
  double rtol = 0;
  Candidate choice;
  std::string spec;                    ///< the choice
  std::optional<double> cpu, error;    ///< of it, between the points of its ladder; nothing: it has none
  const CorpusRow* best = nullptr;     ///< the cheapest that met the tolerance
  [[nodiscard]] double ratio() const;  ///< infinity where the choice did not end well
  [[nodiscard]] bool within(double limit) const;
};
/// Every scene with constants fitted to the scenes of all other classes. Those that no reference can judge or
/// that nobody solved are left out.
[[nodiscard]] std::vector<HeldOut> held_out_choices(std::span<const CorpusRow> rows,
                                                    std::span<const CostPoint> points);

/// fitted_constants.hpp.
///   origin  lines that say where they come from
[[nodiscard]] std::string constants_header(const CostConstants& constants,
                                           std::span<const std::string> origin);

}  // namespace superstep
