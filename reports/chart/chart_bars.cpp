/// Horizontal bars.

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/chart/chart.hpp"
#include "reports/chart/chart_figure.hpp"
#include "reports/chart/chart_scale.hpp"
#include "reports/chart/svg.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

constexpr double width = 480, row_height = 22, top = 6, bottom_room = 42, right = 62;
constexpr std::size_t longest_label = 30;

double label_room(const BarChart& chart) {
  double room = 40;
  for (const auto& bar : chart.bars) room = std::max(room, text_width(shortened(bar.label, longest_label)));
  return room + 12;
}

std::string bars_svg(const BarChart& chart) {
  const double left = label_room(chart), plot = row_height * static_cast<double>(chart.bars.size());
  double most = 0;
  for (const auto& bar : chart.bars) most = std::max({most, bar.value, bar.high});
  const ChartScale scale({.label = chart.axis}, 0, most > 0 ? most : 1, left, width - right);
  Svg svg(width, top + plot + bottom_room, chart.title + ". " + chart.caption);
  for (const auto& tick : scale.ticks()) {
    const double x = scale.pixel(tick.value);
    svg.line(x, top, x, top + plot, R"(stroke="currentColor" stroke-opacity="0.14")");
    svg.text(x, top + plot + 16, tick.label, {"middle"});
  }
  double y = top;
  for (const auto& bar : chart.bars) {
    const double middle = y + row_height / 2, end = scale.pixel(bar.value);
    svg.text(left - 8, middle + 4, shortened(bar.label, longest_label), {"end"});
    svg.rectangle(left, y + 3, std::max(0.6, end - left), row_height - 6,
                  fmt::format(R"(fill="{}")", bar.colour),
                  bar.note.empty() ? bar.label + ": " + bar.shown : bar.note);
    double text_at = end;
    if (bar.high > bar.low) {
      const double a = scale.pixel(bar.low), b = scale.pixel(bar.high);
      svg.line(a, middle, b, middle, R"(stroke="currentColor" stroke-width="1.4")");
      svg.line(a, middle - 4, a, middle + 4, R"(stroke="currentColor" stroke-width="1.4")");
      svg.line(b, middle - 4, b, middle + 4, R"(stroke="currentColor" stroke-width="1.4")");
      text_at = std::max(text_at, b);
    }
    svg.text(text_at + 6, middle + 4, bar.shown);
    y += row_height;
  }
  svg.line(left, top, left, top + plot, R"(stroke="currentColor" stroke-opacity="0.6")");
  svg.text((left + width - right) / 2, top + plot + 35, chart.axis, {"middle", R"(font-weight="600")"});
  return svg.take();
}

}  // namespace

std::string bar_figure(const BarChart& chart) {
  nlohmann::ordered_json data = {{"columns", {"label", chart.axis, "low", "high"}},
                                 {"rows", nlohmann::ordered_json::array()}};
  for (const auto& bar : chart.bars) data["rows"].push_back({bar.label, bar.value, bar.low, bar.high});
  return figure("bars", chart.id, chart.title, chart.caption, bars_svg(chart), data);
}

}  // namespace superstep
