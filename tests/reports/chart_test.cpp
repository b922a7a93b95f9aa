#include "reports/chart/chart.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "integrators/registry.hpp"
#include "reports/chart/chart_packing.hpp"
#include "reports/chart/chart_scale.hpp"
#include "support/markup.hpp"

namespace superstep {
namespace {

using test::MarkupReader;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(ChartScale, CoversTheDataWithRoundTicks) {
  const ChartScale scale({.label = ""}, 0.13, 9.7, 100, 200);
  ASSERT_EQ(scale.ticks().size(), 6U);
  EXPECT_EQ(scale.ticks().front().value, 0);
  EXPECT_EQ(scale.ticks().back().value, 10);
  EXPECT_DOUBLE_EQ(scale.pixel(5), 150);
  EXPECT_TRUE(scale.shows(9.7));
  EXPECT_FALSE(scale.shows(11));
  EXPECT_FALSE(scale.shows(nan));
}

TEST(ChartScale, LogarithmsPlaceDecadesEvenly) {
  const ChartScale scale({.label = "", .logarithmic = true}, 2e-9, 3e-3, 0, 700);
  EXPECT_DOUBLE_EQ(scale.pixel(1e-9), 0);
  EXPECT_NEAR(scale.pixel(1e-5), 400, 1e-9);  // rounding of logarithms
  EXPECT_NEAR(scale.pixel(1e-2), 700, 1e-9);
  EXPECT_FALSE(scale.shows(0));
  EXPECT_FALSE(scale.shows(-1));
}

TEST(ChartScale, SurvivesDegenerateAndHugeRanges) {
  for (const bool logarithmic : {false, true})
    for (const auto& [low, high] :
         {std::pair{1.0, 1.0},
          {0.0, 0.0},
          {1e-300, 1e300},
          {5.0, 5.0000001},
          {-3.0, -3.0},
          {300.0, std::nextafter(300.0, 301.0)},  // a steady probe: no tick is one step after another
          {300.0, 300.0 + 1e-9},
          {1e20, 1e20 + 16384},
          {0.0, 5e-324},
          {-1.7e308, 1.7e308}}) {
      const ChartScale scale({.label = "", .logarithmic = logarithmic}, low, high, 0, 100);
      EXPECT_LT(scale.ticks().size(), 1000U) << low << ' ' << high;
      for (const auto& tick : scale.ticks()) EXPECT_TRUE(std::isfinite(scale.pixel(tick.value)));
    }
}

Chart small_chart() {
  return {
      .id = "c",
      .title = "a chart",
      .caption = "",
      .x = {.label = "x"},
      .y = {.label = "y"},
      .series = {{.name = "one", .look = {"#123456", "", Marker::circle}, .x = {0, 1, 2}, .y = {0, 5, 10}}}};
}

TEST(Chart, PointsStandWhereTheirValuesAre) {
  // The plot spans x 70 .. 466 and y 266 .. 16 [px]; the middle point is in the middle.
  EXPECT_NE(chart_svg(small_chart()).find(R"(cx="268.0" cy="141.0")"), std::string::npos)
      << chart_svg(small_chart());
}

TEST(Chart, WhatCannotBeShownBreaksTheLineAndNothingElse) {
  Chart chart = small_chart();
  chart.y.logarithmic = true;
  chart.series[0].x = {0, 1, 2, 3, nan};
  chart.series[0].y = {1e-310, 1, nan, 10, 5};
  const std::string svg = chart_svg(chart);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_EQ(MarkupReader(svg).problem(), "");
  chart.series.clear();
  EXPECT_EQ(MarkupReader(chart_svg(chart)).problem(), "") << "a chart without series";
}

TEST(Chart, HostileNamesStayText) {
  const std::string hostile =
      "</script></svg><img src=x onerror=alert(1)> \" ' & \xff ünï" + std::string(200, 'x');
  Chart chart = small_chart();
  chart.title = chart.caption = chart.x.label = chart.y.label = chart.series[0].name = hostile;
  chart.failures = {hostile};
  BarChart bars{.id = hostile, .title = hostile, .caption = hostile, .axis = hostile};
  bars.bars = {{.label = hostile, .note = hostile, .colour = "#123456", .value = 1, .shown = hostile}};
  GridChart grid{.id = "g", .title = hostile, .caption = hostile, .x_label = hostile, .y_label = hostile};
  grid.columns = grid.rows = {hostile};
  grid.cells = {GridChart::Cell{.shown = hostile, .note = hostile, .good = false}};
  for (const std::string& markup : {chart_figure(chart), bar_figure(bars), grid_figure(grid)}) {
    MarkupReader reader(markup);
    EXPECT_EQ(reader.problem(), "") << markup;
    EXPECT_EQ(reader.count("img"), 0);
    EXPECT_EQ(reader.count("script"), 1) << "the data of the chart";
  }
}

TEST(Palette, EveryMethodHasALookOfItsOwnThatDoesNotDependOnTheCompany) {
  std::set<std::string> colours;
  for (const auto& entry : integrators()) colours.insert(method_look(entry.name).colour);
  EXPECT_EQ(colours.size(), integrators().size());
  const std::vector<std::string> few = {"sts:n=5,nu=1e-3", "cvode"};
  const std::vector<std::string> many = {"cvode", "rkc:rtol=1e-3", "sts:n=5,nu=1e-3", "auto"};
  EXPECT_EQ(looks_of(few)[0].colour, looks_of(many)[2].colour);
  EXPECT_EQ(looks_of(few)[1].colour, looks_of(many)[0].colour);
}

TEST(Palette, SettingsOfOneMethodAreToldApart) {
  const std::vector<std::string> specs = {"sts:n=5,nu=1e-3", "sts:n=10,nu=1e-3", "sts:n=5,nu=1e-4",
                                          "sts:n=10,nu=1e-4"};
  const auto looks = looks_of(specs);
  EXPECT_NE(looks[0].colour, looks[1].colour);
  EXPECT_EQ(looks[0].colour, looks[2].colour);
  EXPECT_NE(looks[0].dash, looks[2].dash);
}

// Relative luminance of WCAG 2.1, https://www.w3.org/TR/WCAG21/#dfn-relative-luminance
double luminance(const std::string& colour) {
  double out = 0;
  const double weights[] = {0.2126, 0.7152, 0.0722};
  for (std::size_t k = 0; k < 3; ++k) {
    const double c = std::stoi(colour.substr(1 + 2 * k, 2), nullptr, 16) / 255.0;
    out += weights[k] * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return out;
}

TEST(Palette, MethodsShowOnWhiteAndOnBlackPaper) {
  for (const auto& entry : integrators()) {
    const double l = luminance(method_look(entry.name).colour);
    EXPECT_GT(1.05 / (l + 0.05), 2.0)
        << entry.name << " on white";  // half the 3 : 1 of thin text: lines are thick
    EXPECT_GT((l + 0.05) / 0.058, 3.0) << entry.name << " on the dark page";  // whose luminance is 0.008
  }
}

TEST(Palette, TheFieldScaleGrowsLighterAllTheWay) {
  double last = -1;
  for (int k = 0; k <= 20; ++k) {
    const double l = luminance(field_colour(k / 20.0));
    EXPECT_GT(l, last);
    last = l;
  }
  EXPECT_EQ(field_colour(-1), field_colour(0));
  EXPECT_EQ(field_colour(nan), field_colour(0));
  EXPECT_EQ(field_colour(2), field_colour(1));
}

TEST(PackingFigure, DrawsEverySphereOncePerTimeBackToFront) {
  Slice slice{.source = "cvode", .cut = 5};
  slice.spheres = {{1, 0, 0, -0.5, 1}, {2, 1, 1, 0.5, 1}};
  slice.frames = {{.field = "temperature", .unit = "K", .time = 0, .value = {0, 1}},
                  {.field = "temperature", .unit = "K", .time = 1, .value = {1, 2}}};
  const std::string markup = packing_figures(slice, "p");
  MarkupReader reader(markup);
  EXPECT_EQ(reader.problem(), "");
  EXPECT_EQ(reader.count("circle"), 4);
  EXPECT_NE(markup.find("Of 5 such spheres 2, chosen at random"), std::string::npos);
  EXPECT_LT(markup.find(field_colour(0.5)), markup.find(field_colour(0))) << "sphere 2 lies behind sphere 1";
}

}  // namespace
}  // namespace superstep
