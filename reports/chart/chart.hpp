#pragma once
/// Charts as plain data, and as figures of the HTML report: an SVG that stands before any script runs, with
/// the numbers beside it for scripts.

#include <optional>
#include <string>
#include <vector>

#include "reports/chart/palette.hpp"

namespace superstep {

struct ChartAxis {
  std::string label;  ///< quantity and unit, e.g. "time [ms]"
  bool logarithmic = false;
  std::optional<double> low{}, high{};  ///< end of the axis; else where the data ends
};

struct ChartSeries {
  enum class Kind { line, points, columns };  ///< a line carries markers too
  std::string name;
  Look look;
  Kind kind = Kind::line;
  bool in_legend = true;
  std::vector<double> x{}, y{};      ///< same length; NaN, and what a logarithm cannot show, is left out
  std::vector<std::string> notes{};  ///< what a point tells when it is pointed at; empty or one per point
};

/// A named stretch of the x axis: the phase of a process.
struct ChartSpan {
  std::string name;
  double begin = 0, end = 0;  ///< in units of the axis
};

/// A line, scatter or column chart.
struct Chart {
  std::string id;              ///< letters, digits, '-'; unique in a page
  std::string title, caption;  ///< plain text; the caption says what to look at
  ChartAxis x, y;
  std::vector<ChartSeries> series{};
  std::vector<ChartSpan> spans{};       ///< shaded in turn behind the series, named above the plot
  std::vector<std::string> failures{};  ///< runs that have no point; each is marked at the upper edge
};

/// The SVG alone; text is escaped, colours are attributes, black is the current colour.
[[nodiscard]] std::string chart_svg(const Chart& chart);

/// <figure> with caption, SVG and the data as JSON.
[[nodiscard]] std::string chart_figure(const Chart& chart);

/// Horizontal bars, one row per label.
struct BarChart {
  struct Bar {
    std::string label, note;  ///< what it is; what it tells when pointed at
    std::string colour;
    double value = 0;
    std::string shown;         ///< the value as text
    double low = 0, high = 0;  ///< whisker; none when equal
  };
  std::string id, title, caption, axis;
  std::vector<Bar> bars{};
};
[[nodiscard]] std::string bar_figure(const BarChart& chart);

/// A grid of cells, good ones and bad ones.
struct GridChart {
  struct Cell {
    double fraction = 0;  ///< 0 = best .. 1 = worst: decides the colour
    std::string shown;    ///< text in the cell
    std::string note{};
    bool good = true;  ///< bad cells are crossed out as well, so that colour is not needed
  };
  std::string id, title, caption, x_label, y_label;
  std::vector<std::string> columns{}, rows{};
  std::vector<std::optional<Cell>> cells{};  ///< [rows * columns], row by row
};
[[nodiscard]] std::string grid_figure(const GridChart& chart);

}  // namespace superstep
