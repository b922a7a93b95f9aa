#pragma once
/// Springback over hold and densification: the trends of Zohdi (2014), figure 8, with their spread over
/// seeds.

#include <string>
#include <vector>

#include "bench/host/progress.hpp"
#include "case/press/press.hpp"

namespace superstep {

/// One press of one bed.
struct PressTableRow {
  std::int64_t seed = 0;
  double upper_wall = 0;  ///< lowest height of the upper wall [m]
  double hold = 0;        ///< s
  std::string status, reason;
  double poured = 0, pressed = 0, released = 0;      ///< volume fractions below that height
  double temperature_hold = 0, temperature_end = 0;  ///< means at the end of the hold and of the run [K]
  std::int64_t bonds = 0;                            ///< at the end

  /// Part of the pressed volume fraction that is lost again.
  [[nodiscard]] double springback() const { return 1 - released / pressed; }
  /// By how much the porosity after release lies below that of the poured bed, relative to that, or in
  /// points.
  [[nodiscard]] double porosity_drop() const { return (released - poured) / (1 - poured); }
  [[nodiscard]] double porosity_points() const { return released - poured; }
};

/// Every hold at every height for every seed of the case's [bench.press_table]. A bed is poured once for its
/// seed and pressed once for each height; each hold is cut out of the longest one. Throws InputError where
/// the case has no such table or no phase that holds, and NumericalError where the pouring fails.
[[nodiscard]] std::vector<PressTableRow> press_table(const Press& one, Progress& progress);

/// Mean and largest distance from it over the seeds, hold by hold; which trends every seed follows.
[[nodiscard]] std::string press_table_text(const std::vector<PressTableRow>& rows);
[[nodiscard]] std::string press_table_csv(const Press& one, const std::vector<PressTableRow>& rows);
/// Heat map of the mean springback.
[[nodiscard]] std::string press_table_svg(const std::vector<PressTableRow>& rows);

}  // namespace superstep
