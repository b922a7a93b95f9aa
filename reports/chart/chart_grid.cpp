/// Maps over two parameters: a cell for each pair.

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/chart/chart.hpp"
#include "reports/chart/chart_figure.hpp"
#include "reports/chart/svg.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

constexpr double width = 480, cell_height = 26, top = 24, left = 122, bottom_room = 30;

std::string grid_svg(const GridChart& chart) {
  const auto columns = static_cast<double>(std::max<std::size_t>(1, chart.columns.size()));
  const double cell_width = (width - left - 8) / columns;
  const double plot = cell_height * static_cast<double>(chart.rows.size());
  Svg svg(width, top + plot + bottom_room, chart.title + ". " + chart.caption);
  for (std::size_t c = 0; c < chart.columns.size(); ++c)
    svg.text(left + cell_width * (static_cast<double>(c) + 0.5), top - 7, shortened(chart.columns[c], 12),
             {"middle"});
  for (std::size_t r = 0; r < chart.rows.size(); ++r) {
    const double y = top + cell_height * static_cast<double>(r);
    svg.text(left - 8, y + cell_height / 2 + 4, shortened(chart.rows[r], 18), {"end"});
    for (std::size_t c = 0; c < chart.columns.size(); ++c) {
      const auto& cell = chart.cells[r * chart.columns.size() + c];
      if (!cell) continue;
      const double x = left + cell_width * static_cast<double>(c);
      const std::string fill =
          cell->good ? tinted("#0f7dc2", 0.8 - 0.6 * std::clamp(cell->fraction, 0.0, 1.0)) : "#d55e00";
      svg.rectangle(x + 1, y + 1, cell_width - 2, cell_height - 2, fmt::format(R"(fill="{}")", fill),
                    cell->note);
      svg.text(x + cell_width / 2, y + cell_height / 2 + 4, cell->good ? cell->shown : "✗ " + cell->shown,
               {"middle", R"(font-size="11" fill="#10151c" pointer-events="none")"});
    }
  }
  svg.text(left - 8, top - 7, chart.y_label, {"end", R"(font-weight="600")"});
  svg.text(left + (width - left) / 2, top + plot + 20, chart.x_label, {"middle", R"(font-weight="600")"});
  return svg.take();
}

}  // namespace

std::string grid_figure(const GridChart& chart) {
  nlohmann::ordered_json data = {{"columns", {chart.y_label, chart.x_label, "value", "good"}},
                                 {"rows", nlohmann::ordered_json::array()}};
  for (std::size_t k = 0; k < chart.cells.size(); ++k)
    if (const auto& cell = chart.cells[k])
      data["rows"].push_back({chart.rows[k / chart.columns.size()], chart.columns[k % chart.columns.size()],
                              cell->shown, cell->good ? "yes" : "no"});
  return figure("grid", chart.id, chart.title, chart.caption, grid_svg(chart), data);
}

}  // namespace superstep
