/// Work and CPU time, published and ours (tables 2 and 4 of Rojek & Nisar 2026).

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "reports/chart/chart.hpp"
#include "reports/html/like_for_like.hpp"
#include "reports/html/sections/paper_parts.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

Number median(const std::optional<Timing>& timing) {
  return timing ? Number(timing->median) : std::nullopt;
}

/// Our speedups with the Joule heat at equal intervals; a run that was measured that way goes before what is
/// reckoned from the cost of an evaluation.
LikeForLike equal_intervals(const BenchCase& one, const PublishedRun& run, const BenchRow& row) {
  LikeForLike out;
  const BenchRow* euler = our_run(one, PublishedRun());  // nu = 0
  if (euler && one.cpu_joule && run.nu != 0) out = like_for_like(*euler, row, *one.cpu_joule);
  if (const BenchRow* measured = our_run(one, run, /*heat_every_substep=*/true))
    out.every_substep = measured->speedup_stepping;
  return out;
}

std::string interval_text(const BenchCase& one, const PublishedCase& published) {
  std::string cost;
  if (one.cpu_joule)
    cost = fmt::format(
        " The last two columns put them on one footing: what was not measured follows from the counted "
        "evaluations at {} µs each, measured beside the runs.",
        number_text(1e6 * *one.cpu_joule));
  return "Our super-time-stepping evaluates the Joule heat once a superstep, forward Euler at every step, so "
         "that our speedups may exceed the theory; the code of " +
         published.source.substr(0, published.source.find(',')) +
         " passes it on at every step of either, and its speedups equal the theory." + cost;
}

}  // namespace

std::string paper_performance(const BenchCase& one, const PublishedCase& published) {
  std::vector<HtmlTable::Header> headers = {{"run", "", false},
                                            {"substeps, published"},
                                            {"ours"},
                                            {"ours / published"},
                                            {"CPU stepping [s], published"},
                                            {"ours"},
                                            {"speedup total, published"},
                                            {"ours"},
                                            {"speedup stepping, published"},
                                            {"ours"},
                                            {"theory", "ours: superstep over N steps of forward Euler"}};
  const bool heats = std::any_of(one.rows.begin(), one.rows.end(),
                                 [](const BenchRow& row) { return row.potential.has_value(); });
  if (heats) {
    headers.push_back({"ours, heat at every substep", "of both methods"});
    headers.push_back({"ours, heat once a superstep", "in both methods"});
  }
  HtmlTable table(std::move(headers), true);
  for (const auto& run : published.runs) {
    const BenchRow* row = our_run(one, run);
    if (!run.substeps || !row) continue;
    const Number ours = substeps(*row);
    std::vector<HtmlTable::Cell> cells = {published_name(run),
                                          number_cell(run.substeps, 7),
                                          number_cell(ours, 7),
                                          ratio_cell(ours, run.substeps),
                                          number_cell(run.cpu_stepping, 5),
                                          number_cell(median(row->cpu_stepping)),
                                          number_cell(run.speedup_total),
                                          number_cell(row->speedup_total),
                                          number_cell(run.speedup_stepping),
                                          number_cell(row->speedup_stepping),
                                          number_cell(row->speedup_theory)};
    if (heats) {
      const LikeForLike equal = equal_intervals(one, run, *row);
      cells.push_back(number_cell(equal.every_substep));
      cells.push_back(number_cell(equal.every_superstep));
    }
    table.add_row(std::move(cells));
  }
  if (table.empty()) return {};
  return fmt::format("<h4>Work and CPU time ({})</h4>\n{}{}", published.performance_table,
                     heats ? "<p>" + html_text(interval_text(one, published)) + "</p>\n" : "", table.html());
}

std::string paper_speedup_figure(const BenchCase& one, const PublishedCase& published,
                                 const std::string& id) {
  ChartSeries diagonal{.name = "equal", .look = {"#8a8a8a", "5 3", Marker::none}, .x = {1, 1}, .y = {1, 1}};
  ChartSeries runs{
      .name = "runs of super-time-stepping", .look = method_look("sts"), .kind = ChartSeries::Kind::points};
  ChartSeries equal{
      .name = "heat at every substep", .look = curve_look(1), .kind = ChartSeries::Kind::points};
  const auto add = [&](ChartSeries& series, const PublishedRun& run, const Number& ours) {
    if (!ours) return;
    series.x.push_back(*run.speedup_stepping);
    series.y.push_back(*ours);
    series.notes.push_back(fmt::format("{}: published {}, ours {}", published_name(run).text,
                                       number_text(*run.speedup_stepping), number_text(*ours)));
    diagonal.x[1] = diagonal.y[1] = std::max({diagonal.x[1], series.x.back(), series.y.back()});
  };
  for (const auto& run : published.runs) {
    const BenchRow* row = our_run(one, run);
    if (run.nu == 0 || !row || !run.speedup_stepping) continue;
    add(runs, run, row->speedup_stepping);
    if (row->potential) add(equal, run, equal_intervals(one, run, *row).every_substep);
  }
  if (runs.x.empty()) return {};
  Chart chart{.id = id + "-paper-speedup",
              .title = "Speedup of stepping, published and ours",
              .caption = "On the line both are equal.",
              .x = {.label = "published", .low = 0.0},
              .y = {.label = "ours", .low = 0.0},
              .series = {diagonal, runs}};
  if (!equal.x.empty()) chart.series.push_back(equal);
  return chart_figure(chart);
}

}  // namespace superstep
