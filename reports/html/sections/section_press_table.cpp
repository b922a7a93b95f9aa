/// Springback over hold and densification. Source of the picture: figure 8 of Zohdi (2014), Math. Mech.
/// Solids 19, 93-113.

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "reports/chart/chart.hpp"
#include "reports/html/html_parts.hpp"
#include "reports/html/sections/sections.hpp"
#include "results/press/press_table_text.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

/// Holds (columns) against heights of the wall (rows) of one case.
GridChart springback_chart(const std::string& name, const std::vector<PressTableCell>& cells) {
  GridChart chart{.id = "springback-" + name,
                  .title = fmt::format("Springback: {}", name),
                  .caption =
                      "Part of the pressed volume fraction that is lost after release, mean over beds; "
                      "✗: no bed ended well.",
                  .x_label = "hold [s]",
                  .y_label = "upper wall [m]"};
  std::set<double> walls, holds;
  double low = 1, high = 0;
  for (const auto& cell : cells) {
    walls.insert(cell.upper_wall);
    holds.insert(cell.hold);
    if (cell.beds == 0) continue;
    low = std::min(low, cell.springback);
    high = std::max(high, cell.springback);
  }
  for (const double wall : walls) chart.rows.push_back(number_text(wall, 4));
  for (const double hold : holds) chart.columns.push_back(number_text(hold, 4));
  chart.cells.resize(walls.size() * holds.size());
  for (const auto& cell : cells) {
    const auto row = std::distance(walls.begin(), walls.find(cell.upper_wall)),
               column = std::distance(holds.begin(), holds.find(cell.hold));
    chart.cells[static_cast<std::size_t>(row) * holds.size() + static_cast<std::size_t>(column)] = {
        .fraction = high > low ? (cell.springback - low) / (high - low) : 0.5,
        .shown = cell.beds > 0 ? number_text(100 * cell.springback, 3) + " %" : "",
        .note = fmt::format("{} beds, +- {} %; poured {}, pressed {}", cell.beds,
                            number_text(100 * cell.spread, 2), number_text(cell.poured, 3),
                            number_text(cell.pressed, 3)),
        .good = cell.beds > 0};
  }
  return chart;
}

}  // namespace

std::string press_table_article(std::span<const PressTableRow> rows) {
  const auto cells = press_table_cells(rows);
  std::string out = fmt::format("<article id=\"press-table\">\n<h2>Hold and densification</h2>\n<p>{}.</p>\n",
                                html_text(press_table_trends(rows)));
  int number = 0;
  for (auto first = cells.begin(); first != cells.end();) {
    const auto last = std::find_if(
        first, cells.end(), [&](const PressTableCell& cell) { return cell.case_name != first->case_name; });
    const std::vector<PressTableCell> own(first, last);
    out += html_section(fmt::format("press-table-{}", ++number), own.front().case_name, "",
                        grid_figure(springback_chart(own.front().case_name, own)) +
                            plain_table_html(press_table_means(own), true));
    first = last;
  }
  return out + "</article>\n";
}

}  // namespace superstep
