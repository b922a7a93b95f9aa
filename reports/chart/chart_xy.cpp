/// Line, scatter and column charts.

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/chart/chart.hpp"
#include "reports/chart/chart_scale.hpp"
#include "reports/chart/svg.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

constexpr double width = 480, plot_height = 250;
constexpr double left = 70, right = 14, top = 16, axis_room = 44, legend_row = 18;
constexpr std::size_t longest_name = 46, longest_span_name = 14;
constexpr std::size_t most_markers = 14;  // on one line
constexpr const char* grid = R"(stroke="currentColor" stroke-opacity="0.14")";
constexpr const char* axis_line = R"(stroke="currentColor" stroke-opacity="0.6")";

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void include(double value, bool logarithmic) {
    if (!std::isfinite(value) || (logarithmic && !(value > 0))) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] bool empty() const { return !(low <= high); }
};

Range range_of(const Chart& chart, const ChartAxis& axis, std::vector<double> ChartSeries::*values) {
  Range range;
  for (const auto& series : chart.series)
    for (const double value : series.*values) range.include(value, axis.logarithmic);
  if (range.empty()) return {axis.logarithmic ? 0.1 : 0.0, 1.0};
  return range;
}

/// Entries of the legend in rows that fit.
struct LegendEntry {
  double x;
  int row;
  const ChartSeries* series;
};

std::vector<LegendEntry> legend_of(const Chart& chart) {
  constexpr double sample = 34, gap = 14;
  std::vector<LegendEntry> entries;
  double x = 8;
  int row = 0;
  for (const auto& series : chart.series) {
    if (!series.in_legend) continue;
    const double needed = sample + text_width(shortened(series.name, longest_name)) + gap;
    if (x > 8 && x + needed > width) {
      x = 8;
      ++row;
    }
    entries.push_back({x, row, &series});
    x += needed;
  }
  return entries;
}

class Plot {
 public:
  explicit Plot(const Chart& chart)
      : chart_(chart),
        legend_(legend_of(chart)),
        x_range_(x_range(chart)),
        y_range_(y_range(chart)),
        x_(chart.x, x_range_.low, x_range_.high, left, width - right),
        y_(chart.y, y_range_.low, y_range_.high, top + plot_height, top),
        svg_(width, height(), chart.title + ". " + chart.caption) {}

  std::string draw() {
    draw_spans();
    draw_axes();
    std::size_t columns = 0, place = 0;
    for (const auto& series : chart_.series) columns += series.kind == ChartSeries::Kind::columns ? 1 : 0;
    for (const auto& series : chart_.series) {
      if (series.kind == ChartSeries::Kind::columns)
        draw_columns(series, place++, columns);
      else
        draw_line(series);
    }
    draw_failures();
    draw_legend();
    return svg_.take();
  }

 private:
  static Range x_range(const Chart& chart) {
    Range range = range_of(chart, chart.x, &ChartSeries::x);
    for (const auto& series : chart.series)
      if (series.kind == ChartSeries::Kind::columns) return {range.low - 0.5, range.high + 0.5};
    return range;
  }
  static Range y_range(const Chart& chart) {
    Range range = range_of(chart, chart.y, &ChartSeries::y);
    for (const auto& series : chart.series)
      if (series.kind == ChartSeries::Kind::columns && !chart.y.logarithmic) range.include(0, false);
    return range;
  }

  [[nodiscard]] double height() const {
    const int rows = legend_.empty() ? 0 : legend_.back().row + 1;
    return top + plot_height + axis_room + legend_row * rows + 6;
  }

  // Every second one is shaded; a name that has no room between its neighbours' is left out of the picture,
  // but pointing at the stretch tells it.
  void draw_spans() {
    double last_name = 0;
    for (std::size_t k = 0; k < chart_.spans.size(); ++k) {
      const auto& span = chart_.spans[k];
      const double begin = std::clamp(x_.pixel(span.begin), left, width - right);
      const double end = std::clamp(x_.pixel(span.end), left, width - right);
      svg_.rectangle(begin, top, end - begin, plot_height,
                     fmt::format(R"(fill="currentColor" fill-opacity="{}")", k % 2 == 0 ? "0.09" : "0"),
                     fmt::format("{}: {} to {}", span.name, number_text(span.begin), number_text(span.end)));
      const std::string name = shortened(span.name, longest_span_name);
      const double half = 0.5 * text_width(name);
      const double middle = std::clamp(0.5 * (begin + end), left + half, width - right - half);
      if (middle - half < last_name) continue;
      svg_.text(middle, top - 4, name, {"middle", R"(fill-opacity="0.75")"});
      last_name = middle + half + 4;
    }
  }

  void draw_axes() {
    const double bottom = top + plot_height;
    double last_label = -1e9;
    for (const auto& tick : x_.ticks()) {
      const double x = x_.pixel(tick.value);
      if (!tick.label.empty()) svg_.line(x, top, x, bottom, grid);
      svg_.line(x, bottom, x, bottom + (tick.label.empty() ? 3 : 5), axis_line);
      const double half = text_width(tick.label) / 2;
      if (tick.label.empty() || x - half < last_label + 6) continue;
      svg_.text(x, bottom + 18, tick.label, {"middle"});
      last_label = x + half;
    }
    for (const auto& tick : y_.ticks()) {
      const double y = y_.pixel(tick.value);
      if (!tick.label.empty()) svg_.line(left, y, width - right, y, grid);
      svg_.line(left - (tick.label.empty() ? 3 : 5), y, left, y, axis_line);
      svg_.text(left - 8, y + 4, tick.label, {"end"});
    }
    svg_.line(left, bottom, width - right, bottom, axis_line);
    svg_.line(left, top, left, bottom, axis_line);
    svg_.text((left + width - right) / 2, bottom + 37, chart_.x.label, {"middle", R"(font-weight="600")"});
    const std::string turned =
        fmt::format(R"~(font-weight="600" transform="rotate(-90 13 {:.0f})")~", top + plot_height / 2);
    svg_.text(13, top + plot_height / 2, chart_.y.label, {"middle", turned.c_str()});
  }

  void draw_line(const ChartSeries& series) {
    const bool joined = series.kind == ChartSeries::Kind::line;
    std::string path;
    std::vector<std::size_t> shown;
    bool pen_down = false;
    for (std::size_t k = 0; k < series.x.size(); ++k) {
      if (!x_.shows(series.x[k]) || !y_.shows(series.y[k])) {
        pen_down = false;
        continue;
      }
      path +=
          fmt::format("{}{:.1f} {:.1f}", pen_down ? "L" : "M", x_.pixel(series.x[k]), y_.pixel(series.y[k]));
      pen_down = true;
      shown.push_back(k);
    }
    if (joined && shown.size() > 1)
      svg_.raw(fmt::format(
          R"(<path d="{}" fill="none" stroke="{}" stroke-width="1.8" stroke-linejoin="round"{}/>)", path,
          series.look.colour,
          series.look.dash.empty() ? "" : fmt::format(R"( stroke-dasharray="{}")", series.look.dash)));
    const std::size_t stride =
        joined ? 1 + (shown.size() - std::min<std::size_t>(1, shown.size())) / most_markers : 1;
    for (std::size_t k = 0; k < shown.size(); k += stride) {
      const std::size_t i = shown[k];
      const std::string note = series.notes.empty()
                                   ? fmt::format("{}: {}, {}", series.name, number_text(series.x[i], 4),
                                                 number_text(series.y[i], 4))
                                   : series.notes[i];
      svg_.marker(x_.pixel(series.x[i]), y_.pixel(series.y[i]), series.look.marker, series.look.colour, note);
    }
  }

  void draw_columns(const ChartSeries& series, std::size_t place, std::size_t count) {
    const double slot = (x_.pixel(1) - x_.pixel(0)) * 0.84, each = slot / static_cast<double>(count);
    const double bottom = top + plot_height;
    for (std::size_t k = 0; k < series.x.size(); ++k) {
      if (!x_.shows(series.x[k]) || !y_.shows(series.y[k])) continue;
      const double x = x_.pixel(series.x[k]) - slot / 2 + each * static_cast<double>(place);
      const double y = y_.pixel(series.y[k]);
      svg_.rectangle(
          x, y, each, bottom - y, fmt::format(R"(fill="{}")", series.look.colour),
          fmt::format("{}: {}, {}", series.name, number_text(series.x[k]), number_text(series.y[k])));
    }
  }

  void draw_failures() {
    for (std::size_t k = 0; k < chart_.failures.size(); ++k)
      svg_.marker(width - right - 8 - 12 * static_cast<double>(k % 30),
                  top + 8 + 12 * static_cast<double>(k / 30), Marker::cross, "#c0392b", chart_.failures[k]);
  }

  void draw_legend() {
    for (const auto& entry : legend_) {
      const double y = top + plot_height + axis_room + legend_row * (entry.row + 0.5);
      const auto& look = entry.series->look;
      if (entry.series->kind == ChartSeries::Kind::columns)
        svg_.rectangle(entry.x + 4, y - 6, 22, 11, fmt::format(R"(fill="{}")", look.colour));
      if (entry.series->kind == ChartSeries::Kind::line)
        svg_.line(entry.x, y, entry.x + 28, y,
                  fmt::format(R"(stroke="{}" stroke-width="1.8"{})", look.colour,
                              look.dash.empty() ? "" : fmt::format(R"( stroke-dasharray="{}")", look.dash)));
      if (entry.series->kind != ChartSeries::Kind::columns)
        svg_.marker(entry.x + 14, y, look.marker, look.colour);
      svg_.text(entry.x + 33, y + 4, shortened(entry.series->name, longest_name));
    }
  }

  const Chart& chart_;
  std::vector<LegendEntry> legend_;
  Range x_range_, y_range_;
  ChartScale x_, y_;
  Svg svg_;
};

}  // namespace

std::string chart_svg(const Chart& chart) {
  return Plot(chart).draw();
}

}  // namespace superstep
