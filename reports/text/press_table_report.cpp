#include "reports/text/press_table_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "results/text/text_table.hpp"

namespace superstep {

std::string press_table_trends(std::span<const PressTableRow> rows) {
  const auto hold = trend_with_hold(rows), densification = trend_with_densification(rows);
  return fmt::format(
      "Less springback with longer hold in {} of {} pairs, with higher densification in {} of {}", hold.less,
      hold.pairs, densification.less, densification.pairs);
}

std::string press_table_text(std::span<const PressTableRow> rows, bool color) {
  TextTable table({{"", "case", TextTable::Align::left},
                   {"", "upper wall [m]"},
                   {"", "hold [s]"},
                   {"", "beds"},
                   {"volume fraction", "poured"},
                   {"volume fraction", "pressed"},
                   {"springback", "mean"},
                   {"springback", "+-"},
                   {"porosity below poured", "relative"},
                   {"porosity below poured", "points"},
                   {"", "cools [K]"}});
  for (const auto& cell : press_table_cells(rows)) {
    const auto number = [&](const char* format, double value) -> TextTable::Cell {
      return {cell.beds > 0 ? fmt::format(fmt::runtime(format), value) : "-"};
    };
    table.add_row({{cell.case_name},
                   {fmt::format("{:.4g}", cell.upper_wall)},
                   {fmt::format("{:.4g}", cell.hold)},
                   {fmt::format("{}", cell.beds)},
                   number("{:.4f}", cell.poured),
                   number("{:.4f}", cell.pressed),
                   number("{:.4f}", cell.springback),
                   number("{:.4f}", cell.spread),
                   number("{:.1f} %", 100 * cell.drop),
                   number("{:.1f}", 100 * cell.points),
                   number("{:.1f}", cell.cooling)});
  }
  std::string text = table.text(color);
  for (const auto& row : rows)
    if (!row.ok())
      text += fmt::format("  {}, seed {}, wall {:.4g} m, hold {:.4g} s: {}: {}\n", row.case_name, row.seed,
                          row.upper_wall, row.hold, row.status, row.reason);
  return text + press_table_trends(rows) + "\n";
}

}  // namespace superstep
