/// Histories at the probes (figures 11, 18 and 20 of Rojek & Nisar 2026).

#include <fmt/format.h>

#include <algorithm>

#include "reports/chart/chart.hpp"
#include "reports/chart/curve_panels.hpp"
#include "reports/html/html_parts.hpp"
#include "reports/html/sections/sections.hpp"

namespace superstep {
namespace {

std::vector<double> scaled(const std::vector<double>& values, double factor) {
  std::vector<double> out = values;
  for (double& value : out) value *= factor;
  return out;
}

/// The reference once, at the instants of the curve that has most of them.
ChartSeries reference_series(const CurvePanel& panel, const TimeUnit& unit) {
  const ProbeCurve* finest = nullptr;
  for (const auto& one : panel.curves)
    if (!one.curve->reference.empty() && (!finest || one.curve->time.size() > finest->time.size()))
      finest = one.curve;
  ChartSeries series{.name = "reference", .look = {"currentColor", "", Marker::none}};
  if (!finest) return series;
  series.x = scaled(finest->time, unit.factor);
  series.y = finest->reference;
  return series;
}

std::string panel_figure(const CurvePanel& panel, const TimeUnit& unit, const std::string& id) {
  const ProbeCurve& first = *panel.curves.front().curve;
  Chart chart{.id = id,
              .title = panel.title,
              .caption = "",
              .x = {.label = fmt::format("time [{}]", unit.name)},
              .y = {.label = fmt::format("{} [{}]", first.field, first.unit)}};
  if (auto reference = reference_series(panel, unit); !reference.x.empty())
    chart.series.push_back(std::move(reference));
  for (const auto& one : panel.curves)
    chart.series.push_back({.name = one.curve->spec,
                            .look = one.look,
                            .x = scaled(one.curve->time, unit.factor),
                            .y = one.curve->value});
  return chart_figure(chart);
}

}  // namespace

std::string probe_section(const CaseInput& input, const std::string& id) {
  const TimeUnit unit = time_unit(input.bench.t_end);
  std::string figures;
  std::size_t number = 0;
  for (const auto& panel : curve_panels(input.bench.observations.curves, "nu"))
    figures += panel_figure(panel, unit, fmt::format("{}-probe-{}", id, ++number));
  return html_section(id + "-probes", "Histories at the probes", "", figure_row(figures));
}

}  // namespace superstep
