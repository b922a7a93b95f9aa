/// Work against error: every method over its ladder of tolerances or steps.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/text/quantity.hpp"
#include "reports/chart/chart.hpp"
#include "reports/html/html_parts.hpp"
#include "reports/html/sections/sections.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

constexpr const char* dashes[] = {"", "7 3", "2 3", "9 3 2 3", "4 2"};

std::vector<std::string> families_of(const WorkPrecision& study) {
  std::vector<std::string> families;
  for (const auto& point : study.points)
    if (std::find(families.begin(), families.end(), point.family) == families.end())
      families.push_back(point.family);
  return families;
}

ChartSeries series_of(const WorkPrecision& study, const std::string& family, const std::string& dash) {
  std::vector<const WorkPrecisionPoint*> points;
  for (const auto& point : study.points)
    if (point.family == family && point.ok() && point.cpu) points.push_back(&point);
  std::sort(points.begin(), points.end(),
            [](auto* a, auto* b) { return a->worst_relative > b->worst_relative; });
  ChartSeries series{.name = family, .look = {}};
  for (const auto* point : points) {
    series.look = method_look(point->integrator);
    series.x.push_back(point->worst_relative);
    series.y.push_back(point->cpu->median);
    series.notes.push_back(fmt::format("{}: error {} of the span, {} s CPU, {}", point->spec,
                                       number_text(point->worst_relative), number_text(point->cpu->median),
                                       quantity(point->sweeps, "sweep")));
  }
  series.look.dash = dash;
  return series;
}

std::string diagram(const WorkPrecision& study, const std::string& id) {
  Chart chart{
      .id = id + "-work-precision-chart",
      .title = "Work against error",
      .caption = "Lower left is better. Red crosses at the upper edge: runs that failed; point at them.",
      .x = {.label = "worst rms error / span of the field", .logarithmic = true},
      .y = {.label = "CPU time [s]", .logarithmic = true}};
  std::map<std::string, std::size_t> seen;  // families of each integrator so far
  for (const auto& family : families_of(study)) {
    const std::string method = family.substr(0, family.find(' '));
    ChartSeries series = series_of(study, family, dashes[seen[method] % std::size(dashes)]);
    if (series.x.empty()) continue;
    ++seen[method];
    chart.series.push_back(std::move(series));
  }
  for (const auto& point : study.points)
    if (!point.ok())
      chart.failures.push_back(fmt::format("{}: {}: {}", point.spec, point.status, point.reason));
  return chart.series.empty() ? "" : chart_figure(chart);
}

std::string winners_html(const WorkPrecision& study) {
  HtmlTable table({{"error / span", "", false},
                   {"fastest", "", false},
                   {"CPU [s]"},
                   {"next best method", "", false},
                   {"lead"},
                   {"over forward Euler", "> where forward Euler does not reach the error at all"}},
                  false);
  for (const auto& level : winners(study)) {
    if (!level.winner) {
      table.add_row({{.text = number_text(level.level, 1)},
                     {.text = "nobody reaches it", .kind = "dim"},
                     {},
                     {},
                     {},
                     {}});
      continue;
    }
    table.add_row({{.text = number_text(level.level, 1)},
                   {.text = level.winner->spec, .kind = "strong"},
                   number_cell(Number(level.winner->cpu->median)),
                   {.text = level.runner_up ? level.runner_up->spec : "nobody"},
                   {.text = level.lead ? number_text(*level.lead) + "×" : ""},
                   {.text = level.over_euler ? number_text(*level.over_euler) + "×" : level.without_euler}});
  }
  return table.empty() ? "" : table.html();
}

std::string failures_html(const WorkPrecision& study) {
  std::string out;
  for (const auto& point : study.points)
    if (!point.ok())
      out += fmt::format("<li class=\"bad\"><b>{}</b>: {}: {}</li>\n", html_text(point.spec),
                         html_text(point.status), html_text(point.reason));
  return out.empty() ? "" : "<details><summary>Runs that failed</summary><ul>\n" + out + "</ul></details>\n";
}

}  // namespace

std::string work_precision_section(const WorkPrecision& study, const std::string& id) {
  const std::string bar =
      study.reference_error && study.span > 0
          ? fmt::format(", known to {} of the span", number_text(*study.reference_error / study.span, 2))
          : "";
  return html_section(
      id + "-work-precision", "Who is fastest at which error",
      fmt::format("Every method over a ladder of tolerances or steps, against {}{}.", study.reference, bar),
      figure_row(diagram(study, id)) + winners_html(study) + failures_html(study));
}

}  // namespace superstep
