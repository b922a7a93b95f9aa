/// What the stability laboratory found.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/chart/chart.hpp"
#include "reports/html/html_parts.hpp"
#include "reports/html/sections/sections.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

const CsvTable* table_of(const StabilityInput& input, const char* name) {
  const auto found = input.tables.find(name);
  return found == input.tables.end() ? nullptr : found->second.get();
}

std::string critical_step_figure(const CsvTable& table) {
  BarChart chart{.id = "stability-critical-step",
                 .title = "Estimates of forward Euler's critical step",
                 .caption = "Relative to the limit found by bisection: at most 1 is safe.",
                 .axis = "estimate / true limit"};
  const auto name = table.column("estimate"), of_limit = table.column("of_limit"),
             stable = table.column("stable"), note = table.column("note");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto value = table.number(row, of_limit);
    if (!value) continue;
    const bool safe = table.text(row, stable) == "yes";
    chart.bars.push_back({.label = table.text(row, name),
                          .note = table.text(row, note),
                          .colour = safe ? "#0f7dc2" : "#d55e00",
                          .value = *value,
                          .shown = number_text(*value) + (safe ? " ✓" : " ✗")});
  }
  return chart.bars.empty() ? "" : bar_figure(chart);
}

void add_once(std::vector<std::string>& list, const std::string& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

std::size_t index_of(const std::vector<std::string>& list, const std::string& value) {
  return static_cast<std::size_t>(std::find(list.begin(), list.end(), value) - list.begin());
}

/// One map per order of the substeps: damping against number of substeps.
std::string rounding_figures(const CsvTable& table) {
  const auto n = table.column("n"), nu = table.column("nu"), order = table.column("order"),
             error = table.column("run_rounding_spans"), right = table.column("right");
  std::vector<std::string> orders, columns, rows;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    add_once(orders, table.text(row, order));
    add_once(columns, table.text(row, n));
    add_once(rows, table.text(row, nu));
  }
  std::string out;
  for (const auto& wanted : orders) {
    GridChart chart{
        .id = fmt::format("stability-rounding-{}", index_of(orders, wanted)),
        .title = fmt::format("Rounding of supersteps, order {}", wanted),
        .caption =
            "Error from rounding alone at the end of a run, in spans of the field; ✗: digits are lost.",
        .x_label = "substeps N",
        .y_label = "damping ν",
        .columns = columns,
        .rows = rows};
    chart.cells.resize(columns.size() * rows.size());
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (table.text(row, order) != wanted) continue;
      const auto value = table.number(row, error);
      const double power = value && *value > 0 ? std::log10(*value) : value ? -16 : 0;
      chart.cells[index_of(rows, table.text(row, nu)) * columns.size() +
                  index_of(columns, table.text(row, n))] = GridChart::Cell{
          .fraction = (power + 16) / 10,
          .shown = value ? number_text(*value, 1) : "∞",
          .note = fmt::format("N = {}, ν = {}, {}", table.text(row, n), table.text(row, nu), wanted),
          .good = table.text(row, right) == "yes"};
    }
    out += grid_figure(chart);
  }
  return out;
}

/// Methods (rows) against points of one sweep (columns): how far values leave their range.
std::string overshoot_figure(const CsvTable& table, const std::string& sweep, const char* parameter,
                             const std::string& label) {
  const auto kind = table.column("sweep"), at = table.column(parameter);
  GridChart chart{
      .id = fmt::format("stability-overshoot-{}", parameter),
      .title = fmt::format("Overshoot over random networks: {}", label),
      .caption = "How far values leave the range of initial and fixed values in the first steps, in spans.",
      .x_label = label,
      .y_label = "method"};
  std::vector<std::size_t> points, measures;
  for (std::size_t row = 0; row < table.rows(); ++row)
    if (table.text(row, kind) == sweep) {
      points.push_back(row);
      chart.columns.push_back(number_text(table.required(row, at), 2));
    }
  constexpr std::string_view prefix = "overshoot_";
  for (std::size_t c = 0; c < table.columns().size(); ++c)
    if (table.columns()[c].starts_with(prefix)) {
      measures.push_back(c);
      std::string name = table.columns()[c].substr(prefix.size());
      std::replace(name.begin(), name.end(), '_', ' ');
      chart.rows.push_back(name);
    }
  for (const std::size_t c : measures)
    for (const std::size_t row : points) {
      const auto value = table.number(row, c);
      chart.cells.push_back(
          value ? std::optional(GridChart::Cell{.fraction = *value, .shown = fmt::format("{:.2f}", *value)})
                : std::nullopt);
    }
  return chart.columns.size() < 2 || chart.rows.empty() ? "" : grid_figure(chart);
}

std::string bounds_figure(const CsvTable& table, const std::string& sweep, const char* parameter,
                          const std::string& label) {
  const auto kind = table.column("sweep"), at = table.column(parameter);
  Chart chart{
      .id = fmt::format("stability-bounds-{}", parameter),
      .title = fmt::format("Bounds of the spectrum: {}", label),
      .caption =
          "Bound over true value: above 1 is safe, close to 1 is cheap. α*: true critical step over the "
          "pairwise one; below the published 0.3 that rule is unstable.",
      .x = {.label = label, .logarithmic = true},
      .y = {.label = "ratio", .low = 0.0}};
  const struct {
    const char* column;
    const char* name;
    Look look;
  } measures[] = {{"edge_over_true", "edge bound", {"#0f7dc2", "", Marker::circle}},
                  {"gershgorin_over_true", "Gershgorin", {"#e69f00", "7 3", Marker::square}},
                  {"alpha_star", "α*", {"#d55e00", "2 3", Marker::triangle}}};
  for (const auto& measure : measures) {
    ChartSeries series{.name = measure.name, .look = measure.look};
    for (std::size_t row = 0; row < table.rows(); ++row)
      if (const auto value = table.number(row, table.column(measure.column));
          value && table.text(row, kind) == sweep) {
        series.x.push_back(table.required(row, at));
        series.y.push_back(*value);
      }
    if (series.x.size() > 1) chart.series.push_back(std::move(series));
  }
  return chart.series.empty() ? "" : chart_figure(chart);
}

std::string verdicts_table(const StabilityInput& input) {
  if (!input.summary || !input.summary->contains("verdicts")) return {};
  HtmlTable table({{"method", "", false}, {"verdict", "", false}, {"why", "", false}}, false);
  for (const auto& verdict : input.summary->at("verdicts")) {
    const std::string grade = verdict.value("grade", "");
    table.add_row({{.text = verdict.value("method", "")},
                   {.text = grade,
                    .kind = grade == "safe"     ? "good"
                            : grade == "unsafe" ? "bad"
                                                : "warn"},
                   {.text = verdict.value("text", ""), .kind = "prose"}});
  }
  return table.empty() ? "" : table.html();
}

std::string methods_table(const CsvTable& table) {
  HtmlTable out({{"method", "", false},
                 {"parameters", "", false},
                 {"order", "", false},
                 {"stages"},
                 {"limit β", "declared end of stability in step × rate"},
                 {"largest |R|", "largest amplification up to its own step"},
                 {"R at the stiff end, theory"},
                 {"measured"},
                 {"agrees", "", false}},
                true);
  const auto column = [&](const char* name) { return table.column(name); };
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const bool agrees = table.text(row, column("agrees")) == "yes";
    out.add_row({{.text = table.text(row, column("method"))},
                 {.text = table.text(row, column("parameters"))},
                 {.text = table.text(row, column("order"))},
                 number_cell(table.number(row, column("stages"))),
                 number_cell(table.number(row, column("beta")), 4),
                 number_cell(table.number(row, column("max_response")), 4),
                 number_cell(table.number(row, column("stiff_theory")), 4),
                 number_cell(table.number(row, column("stiff_measured")), 4),
                 {.text = agrees ? "yes" : "no", .kind = agrees ? "good" : "bad"}});
  }
  return out.empty()
             ? ""
             : "<details><summary>Every method and parameter set</summary>\n" + out.html() + "</details>\n";
}

std::string states_table(const CsvTable& table) {
  HtmlTable out({{"t [s]", "of the state at which the scene was frozen"},
                 {"spectrum", "", false},
                 {"|λ| [1/s]", "of the eigenvalue that limits forward Euler"},
                 {"bound [1/s]", "certified, of the spectral radius"},
                 {"method", "", false},
                 {"parameters", "", false},
                 {"predicted [s]", "longest stable step, from eigenvalues"},
                 {"measured [s]", "longest step without growth"},
                 {"ratio", "predicted over measured"},
                 {"verdict", "within 2 %", false}},
                true);
  const auto column = [&](const char* name) { return table.column(name); };
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string verdict = table.text(row, column("verdict"));
    out.add_row({number_cell(table.number(row, column("time_s")), 4),
                 {.text = table.text(row, column("spectrum"))},
                 number_cell(table.number(row, column("lambda_max")), 5),
                 number_cell(table.number(row, column("certified_bound")), 5),
                 {.text = table.text(row, column("method"))},
                 {.text = table.text(row, column("parameters"))},
                 number_cell(table.number(row, column("limit_predicted_s")), 5),
                 number_cell(table.number(row, column("limit_measured_s")), 5),
                 number_cell(table.number(row, column("predicted_over_measured")), 4),
                 {.text = verdict,
                  .kind = verdict == "agrees"    ? "good"
                          : verdict == "differs" ? "bad"
                                                 : "warn"}});
  }
  return out.empty() ? "" : "<h4>Limits at states of a run</h4>\n" + out.html();
}

std::string notes_text(const StabilityInput& input) {
  if (!input.summary || !input.summary->contains("notes")) return {};
  std::string out;
  for (const auto& note : input.summary->at("notes"))
    if (note.is_string()) out += fmt::format("<p>{}</p>\n", html_text(note.get<std::string>()));
  return out;
}

}  // namespace

std::string stability_section(const StabilityInput& input) {
  std::string figures, tables = verdicts_table(input);
  if (const auto* table = table_of(input, "critical_step")) figures += critical_step_figure(*table);
  if (const auto* table = table_of(input, "rounding")) figures += rounding_figures(*table);
  if (const auto* table = table_of(input, "sweeps")) {
    figures += bounds_figure(*table, "contrast", "contrast", "contrast of conductances");
    figures += bounds_figure(*table, "size ratio", "size_ratio", "ratio of sizes");
    figures += overshoot_figure(*table, "nu", "nu", "damping ν");
    figures += overshoot_figure(*table, "contrast", "contrast", "contrast of conductances");
  }
  if (const auto* table = table_of(input, "states")) tables += states_table(*table) + notes_text(input);
  if (const auto* table = table_of(input, "methods")) tables += methods_table(*table);
  const std::string of = input.summary ? " of " + input.summary->value("case", std::string("a case")) : "";
  return html_section("stability", "Where methods are stable",
                      fmt::format("Stability laboratory{}: theory, and measurements on the network.", of),
                      figure_row(figures) + tables);
}

}  // namespace superstep
