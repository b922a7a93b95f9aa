/// CPU time of all runs, and the speedup of super-time-stepping against its theory (figures 13, 14, 22, 23 of
/// Rojek & Nisar 2026).

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "integrators/schemes/super_step.hpp"
#include "reports/chart/chart.hpp"
#include "reports/html/html_parts.hpp"
#include "reports/html/sections/sections.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

std::string cpu_figure(const BenchCase& one, const std::string& id) {
  BarChart chart{.id = id + "-cpu",
                 .title = "CPU time of stepping",
                 .caption = "Median of the repetitions; whiskers from the fastest to the slowest.",
                 .axis = "CPU time [s]"};
  for (const auto& row : one.rows)
    if (row.cpu_stepping)
      chart.bars.push_back(
          {.label = row.spec,
           .note = fmt::format("{}: {} s", row.spec, number_text(row.cpu_stepping->median, 4)),
           .colour = method_look(row.integrator).colour,
           .value = row.cpu_stepping->median,
           .shown = number_text(row.cpu_stepping->median),
           .low = row.cpu_stepping->min,
           .high = row.cpu_stepping->max});
  return chart.bars.empty() ? "" : bar_figure(chart);
}

std::string speedup_figure(const BenchCase& one, const std::string& id) {
  BarChart chart{.id = id + "-speedup",
                 .title = "Speedup over the baseline",
                 .caption = "CPU time of stepping of the baseline over that of the run.",
                 .axis = "speedup"};
  for (const auto& row : one.rows)
    if (row.speedup_stepping)
      chart.bars.push_back({.label = row.spec,
                            .note = "",
                            .colour = method_look(row.integrator).colour,
                            .value = *row.speedup_stepping,
                            .shown = number_text(*row.speedup_stepping)});
  return chart.bars.size() < 2 ? "" : bar_figure(chart);
}

struct Measured {
  double n;
  const BenchRow* row;
};

/// STS runs by damping, in order of n.
std::map<double, std::vector<Measured>, std::greater<>> sts_runs(const BenchCase& one) {
  std::map<double, std::vector<Measured>, std::greater<>> runs;
  for (const auto& row : one.rows) {
    const auto n = parameter(row, "n"), nu = parameter(row, "nu");
    constexpr double most = 10000;  // of any run; a file may say anything
    if (row.integrator == "sts" && n && *n >= 1 && *n <= most && nu && row.speedup_stepping)
      runs[*nu].push_back({*n, &row});
  }
  for (auto& [nu, list] : runs)
    std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.n < b.n; });
  return runs;
}

std::string theory_figure(const BenchCase& one, const std::string& id, Number BenchRow::*speedup,
                          const std::string& what) {
  static const char* const dashes[] = {"", "7 3", "2 3", "9 3 2 3"};
  static const Marker markers[] = {Marker::circle, Marker::square, Marker::triangle, Marker::diamond};
  const auto runs = sts_runs(one);
  Chart chart{.id = id + "-theory-" + what,
              .title = fmt::format("Speedup of super-time-stepping: {}", what),
              .caption = "Marks: measured. Grey lines: theory, superstep over N steps of forward Euler.",
              .x = {.label = "substeps N in a superstep"},
              .y = {.label = "speedup", .low = 0.0}};
  std::size_t k = 0;
  const double shades = std::max<double>(1, static_cast<double>(runs.size()) - 1);
  for (const auto& [nu, list] : runs) {
    ChartSeries theory{.name = fmt::format("theory, ν = {}", number_text(nu)),
                       .look = {"#8a8a8a", dashes[k % 4], Marker::none}};
    const int last = static_cast<int>(list.back().n);
    for (int n = 1; n <= last; ++n) {
      theory.x.push_back(n);
      theory.y.push_back(superstep_length(n, nu) / n);
    }
    const std::string colour = tinted(method_look("sts").colour, 0.5 * (1 - static_cast<double>(k) / shades));
    ChartSeries measured{.name = fmt::format("measured, ν = {}", number_text(nu)),
                         .look = {colour, "", markers[k % 4]},
                         .kind = ChartSeries::Kind::points};
    for (const auto& [n, row] : list) {
      measured.x.push_back(n);
      measured.y.push_back((row->*speedup).value_or(0));
    }
    chart.series.push_back(std::move(theory));
    chart.series.push_back(std::move(measured));
    ++k;
  }
  return chart.series.empty() ? "" : chart_figure(chart);
}

}  // namespace

std::string speed_section(const CaseInput& input, const std::string& id) {
  const BenchCase& one = input.bench;
  std::string figures = theory_figure(one, id, &BenchRow::speedup_stepping, "stepping only");
  figures += theory_figure(one, id, &BenchRow::speedup_total, "total CPU time");
  figures += cpu_figure(one, id) + speedup_figure(one, id);
  return html_section(id + "-speed", "Speed",
                      "CPU time of the whole process, one run after the other in turn.", figure_row(figures));
}

}  // namespace superstep
