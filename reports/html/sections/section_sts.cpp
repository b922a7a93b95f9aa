/// What a superstep is made of (figures 2 to 6 of Rojek & Nisar 2026), from the formulas of the method.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "integrators/schemes/super_step.hpp"
#include "reports/chart/chart.hpp"
#include "reports/html/html_parts.hpp"
#include "reports/html/sections/sections.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

/// Dampings and numbers of substeps that the benchmark ran.
struct Choices {
  std::set<double, std::greater<>> nu;
  std::set<int> n;
};

constexpr int most_columns = 40;  // a column chart with more cannot be read

Choices choices_of(const BenchCase& one) {
  Choices out;
  for (const auto& row : one.rows) {
    if (row.integrator != "sts") continue;
    const auto n = parameter(row, "n"), nu = parameter(row, "nu");
    if (nu && *nu > 0 && *nu < 1) out.nu.insert(*nu);
    if (n && *n >= 1 && *n <= most_columns) out.n.insert(static_cast<int>(*n));
  }
  return out;
}

/// The paper shows N = 10 and 20; else two of those that were run.
std::vector<int> shown_numbers(const std::set<int>& all) {
  if (all.contains(10) && all.contains(20)) return {10, 20};
  std::vector<int> out(all.begin(), all.end());
  if (out.size() > 2) out = {out[out.size() / 2], out.back()};
  return out;
}

Look look_of(std::size_t k, std::size_t count) {
  static const char* const dashes[] = {"", "7 3", "2 3", "9 3 2 3", "4 2"};
  static const Marker markers[] = {Marker::circle, Marker::square, Marker::triangle, Marker::diamond,
                                   Marker::plus};
  const double share = count > 1 ? static_cast<double>(k) / static_cast<double>(count - 1) : 1;
  return {tinted(method_look("sts").colour, 0.6 * (1 - share)), dashes[k % 5], markers[k % 5]};
}

template <class Values>
void add_series(Chart& chart, const Choices& choices, ChartSeries::Kind kind, Values values) {
  std::size_t k = 0;
  for (const double nu : choices.nu) {
    ChartSeries series{.name = fmt::format("ν = {}", number_text(nu)),
                       .look = look_of(k++, choices.nu.size()),
                       .kind = kind};
    values(nu, series);
    chart.series.push_back(std::move(series));
  }
}

void add_euler(Chart& chart, std::vector<double> x, std::vector<double> y) {
  chart.series.push_back({.name = "forward Euler",
                          .look = {method_look("forward-euler").colour, "5 3", Marker::none},
                          .x = std::move(x),
                          .y = std::move(y)});
}

std::string substeps_figure(const Choices& choices, int n, const std::string& id) {
  Chart chart{.id = fmt::format("{}-substeps-{}", id, n),
              .title = fmt::format("Substeps of a superstep, N = {}", n),
              .caption =
                  "Logarithmic. Long ones would be unstable alone; the short ones that follow damp what "
                  "they excite.",
              .x = {.label = "substep j", .low = 0.5, .high = n + 0.5},
              .y = {.label = "substep / critical step", .logarithmic = true}};
  add_series(chart, choices, ChartSeries::Kind::columns, [&](double nu, ChartSeries& series) {
    series.y = superstep_substeps(n, nu);
    for (int j = 1; j <= n; ++j) series.x.push_back(j);
  });
  add_euler(chart, {0.5, n + 0.5}, {1, 1});
  return chart_figure(chart);
}

std::string cumulative_figure(const Choices& choices, int n, const std::string& id) {
  Chart chart{.id = fmt::format("{}-cumulative-{}", id, n),
              .title = fmt::format("Time covered within a superstep, N = {}", n),
              .caption = "Each substep costs as much as one step of forward Euler.",
              .x = {.label = "substep j"},
              .y = {.label = "time / critical step", .low = 0.0}};
  std::vector<double> steps;
  for (int j = 0; j <= n; ++j) steps.push_back(j);
  add_series(chart, choices, ChartSeries::Kind::line, [&](double nu, ChartSeries& series) {
    series.x = steps;
    series.y = {0};
    for (const double substep : superstep_substeps(n, nu)) series.y.push_back(series.y.back() + substep);
  });
  add_euler(chart, steps, steps);
  return chart_figure(chart);
}

std::string gain_figure(const Choices& choices, const std::string& id) {
  Chart chart{.id = id + "-gain",
              .title = "Speedup that theory promises",
              .caption = "Superstep over N critical steps; damping bounds it by 1/(2 √ν).",
              .x = {.label = "substeps N in a superstep"},
              .y = {.label = "theoretical speedup", .low = 0.0}};
  const int last = std::max(30, *choices.n.rbegin());
  add_series(chart, choices, ChartSeries::Kind::line, [&](double nu, ChartSeries& series) {
    for (int n = 1; n <= last; ++n) {
      series.x.push_back(n);
      series.y.push_back(superstep_length(n, nu) / n);
    }
  });
  return chart_figure(chart);
}

std::string response_figure(const Choices& choices, int n, const std::string& id) {
  Chart chart{
      .id = fmt::format("{}-response-{}", id, n),
      .title = fmt::format("What a superstep leaves of a mode, N = {}", n),
      .caption = "Stable while the amplification stays below 1; ν decides how firmly fast modes are damped.",
      .x = {.label = "rate of the mode / fastest stable rate", .low = 0.0, .high = 1.05},
      .y = {.label = "|amplification|", .logarithmic = true, .low = 1e-4, .high = 10.0}};
  constexpr int pieces = 400;
  add_series(chart, choices, ChartSeries::Kind::line, [&](double nu, ChartSeries& series) {
    const auto substeps = superstep_substeps(n, nu);
    series.look.marker = Marker::none;
    for (int k = 0; k <= pieces; ++k) {
      const double z = 2.1 * k / pieces;  // critical step x rate; forward Euler is stable up to 2
      double product = 1;
      for (const double substep : substeps) product *= 1 - z * substep;
      series.x.push_back(z / 2);
      series.y.push_back(std::max(std::abs(product), 1e-4));
    }
  });
  return chart_figure(chart);
}

}  // namespace

std::string sts_section(const CaseInput& input, const std::string& id) {
  const Choices choices = choices_of(input.bench);
  if (choices.nu.empty() || choices.n.empty()) return {};
  std::string figures;
  const auto numbers = shown_numbers(choices.n);
  for (const int n : numbers) figures += substeps_figure(choices, n, id);
  for (const int n : numbers) figures += cumulative_figure(choices, n, id);
  figures += gain_figure(choices, id) + response_figure(choices, numbers.front(), id);
  return html_section(id + "-sts", "How super-time-stepping works",
                      "Computed from the formulas of the method for the parameters of this benchmark.",
                      figure_row(figures));
}

}  // namespace superstep
