#include "results/press/press_table_text.hpp"

#include <fmt/format.h>

namespace superstep {

PlainTable press_table_means(std::span<const PressTableCell> cells) {
  PlainTable table{
      .id = "means",
      .title = "Hold and densification",
      .intro =
          "Fractions of the volume below the lowest height of the wall; springback is the "
          "part of the pressed one that is lost after release, +- the largest distance of "
          "a bed from the mean; porosity after release lies below that of the poured bed.",
      .headers = {"case", "upper wall [m]", "hold [s]", "beds", "poured", "pressed", "springback [%]",
                  "+- [%]", "porosity below poured [%]", "in points", "cools [K]"}};
  for (const auto& cell : cells) {
    const auto number = [&](double value, int digits) -> PlainTable::Cell {
      return {.text = cell.beds > 0 ? fmt::format("{:.{}f}", value, digits) : "-"};
    };
    table.rows.push_back({{.text = cell.case_name},
                          {.text = fmt::format("{:.4g}", cell.upper_wall)},
                          {.text = fmt::format("{:.4g}", cell.hold)},
                          {.text = fmt::format("{}", cell.beds)},
                          number(cell.poured, 4),
                          number(cell.pressed, 4),
                          number(100 * cell.springback, 2),
                          number(100 * cell.spread, 2),
                          number(100 * cell.drop, 1),
                          number(100 * cell.points, 1),
                          number(cell.cooling, 1)});
  }
  return table;
}

std::string press_table_trends(std::span<const PressTableRow> rows) {
  const auto hold = trend_with_hold(rows), densification = trend_with_densification(rows);
  return fmt::format(
      "Less springback with longer hold in {} of {} pairs, with higher densification in {} of {}", hold.less,
      hold.pairs, densification.less, densification.pairs);
}

std::string press_table_text(std::span<const PressTableRow> rows, bool color) {
  std::string text = terminal_text(press_table_means(press_table_cells(rows)), color);
  for (const auto& row : rows)
    if (!row.ok())
      text += fmt::format("  {}, seed {}, wall {:.4g} m, hold {:.4g} s: {}: {}\n", row.case_name, row.seed,
                          row.upper_wall, row.hold, row.status, row.reason);
  return text + press_table_trends(rows) + "\n";
}

}  // namespace superstep
