/// A corpus: which method for which scenes, performance profiles, size and memory, `auto`, what failed.

#include <fmt/format.h>

#include <algorithm>

#include "reports/chart/chart.hpp"
#include "reports/html/html_parts.hpp"
#include "reports/html/sections/sections.hpp"
#include "results/corpus/corpus_summary.hpp"
#include "results/corpus/corpus_tables.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

/// Steps of a profile as the corners of a line, from 1 to the largest factor shown.
ChartSeries profile_series(const Profile& profile, double largest) {
  ChartSeries series{.name = profile.integrator, .look = method_look(profile.integrator)};
  series.look.marker = Marker::none;
  const auto add = [&](double factor, double part) {
    series.x.push_back(factor);
    series.y.push_back(100 * part);
    series.notes.push_back(fmt::format("{}: within {}x of the best in {:.0f} %", profile.integrator,
                                       number_text(factor), 100 * part));
  };
  for (double factor = 1; factor <= largest; factor *= 1.15) add(factor, profile.within(factor));
  return series;
}

std::string profile_figures(std::span<const CorpusCell> cells) {
  constexpr double largest = 100;
  std::string out;
  std::vector<double> levels = {0};
  levels.insert(levels.end(), corpus_levels().begin(), corpus_levels().end());
  for (const double level : levels) {
    const std::string at = level > 0 ? fmt::format(", error {:.0e}", level) : ", all errors";
    Chart chart{.id = fmt::format("corpus-profile-{}", level > 0 ? fmt::format("{:.0e}", level) : "all"),
                .title = "Performance profile" + at,
                .caption =
                    "Upper left is better: the part of the scenes in which a method is within a factor of "
                    "the best one. Where a line ends below 100 %, the method does not reach the error.",
                .x = {.label = "CPU over that of the best", .logarithmic = true, .low = 1, .high = largest},
                .y = {.label = "scenes [%]", .low = 0, .high = 100}};
    for (const auto& profile : corpus_profiles(cells, level))
      chart.series.push_back(profile_series(profile, largest));
    if (!chart.series.empty()) out += chart_figure(chart);
  }
  return out;
}

/// One quantity of the cheapest SPEC of every method against the number of unknowns, at one error.
std::string size_figure(std::span<const CorpusCell> cells, double level, const std::string& what,
                        const std::string& label, Number (*value)(const CorpusRow&)) {
  Chart chart{
      .id = "corpus-size-" + what,
      .title = label + " against size",
      .caption = fmt::format("The cheapest settings of each method that reach an error of {:.0e}; one "
                             "point a scene.",
                             level),
      .x = {.label = "unknowns", .logarithmic = true},
      .y = {.label = label, .logarithmic = true}};
  for (const auto& cell : cells) {
    if (cell.level != level) continue;
    for (const auto& entrant : cell.entrants) {
      const Number number = value(*entrant.row);
      if (!number || !(*number > 0)) continue;
      auto series = std::find_if(chart.series.begin(), chart.series.end(),
                                 [&](const ChartSeries& one) { return one.name == entrant.row->integrator; });
      if (series == chart.series.end()) {
        series =
            chart.series.insert(chart.series.end(), ChartSeries{.name = entrant.row->integrator,
                                                                .look = method_look(entrant.row->integrator),
                                                                .kind = ChartSeries::Kind::points});
      }
      series->x.push_back(static_cast<double>(cell.facts->unknowns));
      series->y.push_back(*number);
      series->notes.push_back(
          fmt::format("{} on {}: {}", entrant.row->spec, cell.facts->scene, number_text(*number)));
    }
  }
  return chart.series.empty() ? "" : chart_figure(chart);
}

/// Every row that is not ok.
std::string all_failures(std::span<const CorpusRow> rows) {
  std::string out;
  for (const auto& row : rows)
    if (!row.ok())
      out += fmt::format("<li class=\"bad\"><b>{}</b> on {}: {}: {}</li>\n", html_text(row.spec),
                         html_text(row.scene), html_text(row.status), html_text(row.reason));
  return out.empty() ? "" : "<details><summary>Every one of them</summary><ul>\n" + out + "</ul></details>\n";
}

}  // namespace

std::string corpus_article(std::span<const CorpusRow> rows) {
  const auto scenes = scenes_of(rows);
  const auto cells = corpus_cells(scenes);
  std::string out =
      fmt::format("<article id=\"corpus\">\n<h2>Corpus</h2>\n<p>{}.</p>\n", html_text(corpus_headline(rows)));
  constexpr double usual_level = 1e-4;
  for (const auto& table : corpus_tables(rows)) {
    std::string body = plain_table_html(table, table.id != "map");
    if (table.id == "profiles") body = figure_row(profile_figures(cells)) + body;
    if (table.id == "winners")
      body += figure_row(size_figure(cells, usual_level, "cpu", "CPU time [s]",
                                     [](const CorpusRow& row) { return row.cpu; }) +
                         size_figure(cells, usual_level, "memory", "memory [MB]",
                                     [](const CorpusRow& row) { return row.memory; }) +
                         size_figure(cells, usual_level, "prepare", "preparation [s]",
                                     [](const CorpusRow& row) { return row.cpu_prepare; }));
    if (table.id == "failures") body += all_failures(rows);
    out += html_section("corpus-" + table.id, table.title, table.intro, body);
  }
  return out + "</article>\n";
}

}  // namespace superstep
