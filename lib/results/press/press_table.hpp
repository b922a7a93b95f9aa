#pragma once
/// What `superstep bench --press-table` finds: springback over hold and densification, bed by bed.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "results/results.hpp"

namespace superstep {

/// One press of one bed.
struct PressTableRow {
  std::string case_name;
  std::uint64_t seed = 0;  ///< of the bed
  double upper_wall = 0;   ///< lowest height of the upper wall [m]
  double hold = 0;         ///< s
  std::string status, reason;
  // Where it ended well: volume fractions below that height, and mean temperatures [K].
  Number poured, pressed, released, temperature_hold, temperature_end;
  std::uint64_t bonds = 0;  ///< at the end

  [[nodiscard]] bool ok() const noexcept { return status == "ok"; }
  /// Part of the pressed volume fraction that is lost again.
  [[nodiscard]] Number springback() const;
  /// By how much the porosity after release lies below that of the poured bed: relative to that, or in
  /// points.
  [[nodiscard]] Number porosity_drop() const;
  [[nodiscard]] Number porosity_points() const;
};

/// Means over the beds of one height and one hold.
struct PressTableCell {
  std::string case_name;
  double upper_wall = 0, hold = 0;
  std::size_t beds = 0;  ///< that ended well
  double springback = 0, drop = 0, points = 0, poured = 0, pressed = 0, cooling = 0;
  double spread = 0;  ///< largest distance of a bed's springback from the mean
};
/// By case, height and hold, all ascending.
[[nodiscard]] std::vector<PressTableCell> press_table_cells(std::span<const PressTableRow> rows);

/// Pairs of neighbours in the table of one bed, and how many of them spring back less.
struct SpringbackTrend {
  std::size_t less = 0, pairs = 0;
};
[[nodiscard]] SpringbackTrend trend_with_hold(std::span<const PressTableRow> rows);
/// From one height to the next lower one.
[[nodiscard]] SpringbackTrend trend_with_densification(std::span<const PressTableRow> rows);

[[nodiscard]] std::string press_table_csv(std::span<const PressTableRow> rows);
/// Throws InputError with file, row and rule.
[[nodiscard]] std::vector<PressTableRow> read_press_table_csv(const std::string& path);
/// {"schema": "superstep.press_table", "schema_version", "rows"}.
[[nodiscard]] std::string press_table_json(std::span<const PressTableRow> rows);

}  // namespace superstep
