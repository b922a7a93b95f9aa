/// How the error at the probes dies away, in linear and logarithmic scale, with the fitted decay (figures 12,
/// 19 and 21 of Rojek & Nisar 2026).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reports/chart/chart.hpp"
#include "reports/chart/curve_panels.hpp"
#include "reports/html/html_parts.hpp"
#include "reports/html/sections/sections.hpp"

namespace superstep {
namespace {

const BenchRow* row_of(const BenchCase& one, const std::string& spec) {
  for (const auto& row : one.rows)
    if (row.spec == spec) return &row;
  return nullptr;
}

/// Decay rate [1/s] that the benchmark fitted for a curve; only the first probe of a field has one.
Number decay_rate(const BenchCase& one, const ProbeCurve& curve) {
  const auto& curves = one.observations.curves;
  const auto first = std::find_if(curves.begin(), curves.end(), [&](const ProbeCurve& other) {
    return other.spec == curve.spec && other.field == curve.field;
  });
  const BenchRow* row = row_of(one, curve.spec);
  if (!row || &*first != &curve) return std::nullopt;
  for (const auto& field : fields_of(one))
    if (field.name == curve.field)
      if (const auto* errors = field.errors(*row)) return errors->decay_rate;
  return std::nullopt;
}

/// |difference| over the transient.
ChartSeries error_series(const LookedCurve& one, const TimeUnit& unit) {
  const ProbeCurve& curve = *one.curve;
  ChartSeries series{.name = curve.spec, .look = one.look};
  for (std::size_t k = 0; k < curve.transient; ++k) {
    series.x.push_back(curve.time[k] * unit.factor);
    series.y.push_back(std::abs(curve.value[k] - curve.reference[k]));
  }
  return series;
}

/// Z exp(-k t) through the logarithmic mean of the errors, k as the benchmark fitted it.
ChartSeries fit_series(const LookedCurve& one, double rate, const TimeUnit& unit) {
  const ProbeCurve& curve = *one.curve;
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < curve.transient; ++k) {
    const double error = std::abs(curve.value[k] - curve.reference[k]);
    if (!(error > 0)) continue;
    sum += std::log(error) + rate * curve.time[k];
    ++count;
  }
  ChartSeries series{.name = fmt::format("fit of {}", curve.spec),
                     .look = {one.look.colour, "1 3", Marker::none},
                     .in_legend = false};
  if (count == 0) return series;
  const double scale = std::exp(sum / count), end = curve.time[curve.transient - 1];
  constexpr int pieces = 40;
  for (int k = 0; k <= pieces; ++k) {
    const double t = end * k / pieces;
    series.x.push_back(t * unit.factor);
    series.y.push_back(scale * std::exp(-rate * t));
  }
  return series;
}

/// Errors begin at 0: what is more than five decades below the largest one would only squeeze the rest.
Number low_end(const Chart& chart) {
  double largest = 0;
  for (const auto& series : chart.series)
    for (const double error : series.y) largest = std::max(largest, error);
  if (!(largest > 0)) return std::nullopt;
  return std::pow(10.0, std::floor(std::log10(largest)) - 5);
}

std::string panel_figure(const BenchCase& one, const CurvePanel& panel, bool logarithmic,
                         const std::string& id) {
  const ProbeCurve& first = *panel.curves.front().curve;
  const TimeUnit unit = time_unit(one.t_end);
  Chart chart{.id = id,
              .title = fmt::format("Error of {}{}", panel.title, logarithmic ? ", logarithmic" : ""),
              .caption = "",
              .x = {.label = fmt::format("time [{}]", unit.name)},
              .y = {.label = fmt::format("|error| [{}]", first.unit), .logarithmic = logarithmic}};
  for (const auto& curve : panel.curves) {
    if (curve.curve->reference.empty() || curve.curve->transient == 0) continue;
    chart.series.push_back(error_series(curve, unit));
    const auto rate = decay_rate(one, *curve.curve);
    if (rate && *rate > 0)  // a fit that grows describes nothing
      if (auto fit = fit_series(curve, *rate, unit); !fit.x.empty()) chart.series.push_back(std::move(fit));
  }
  if (logarithmic) chart.y.low = low_end(chart);
  return chart.series.empty() ? "" : chart_figure(chart);
}

}  // namespace

std::string error_section(const CaseInput& input, const std::string& id) {
  const BenchCase& one = input.bench;
  std::string figures;
  std::size_t number = 0;
  for (const auto& panel : curve_panels(one.observations.curves, "n")) {
    ++number;
    figures += panel_figure(one, panel, false, fmt::format("{}-error-{}-lin", id, number));
    figures += panel_figure(one, panel, true, fmt::format("{}-error-{}-log", id, number));
  }
  return html_section(
      id + "-errors", "How the error dies away",
      "Difference to the reference at the probe during the transient, that is until the reference stays "
      "within 1 % of its final value. Dotted: the fit Z exp(-k t), where the error falls.",
      figure_row(figures));
}

}  // namespace superstep
