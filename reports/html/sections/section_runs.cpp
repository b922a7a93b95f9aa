/// Folders of `superstep run`: what was integrated, with which method, and what came out.

#include <fmt/format.h>

#include "reports/chart/chart.hpp"
#include "reports/chart/chart_packing.hpp"
#include "reports/chart/curve_panels.hpp"
#include "reports/html/html_parts.hpp"
#include "reports/html/sections/sections.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

std::string spec_of(const RunRecord& run) {
  return run.integrator + (run.params.empty() ? "" : ":" + run.params);
}

std::string runs_table(std::span<const RunInput> runs) {
  HtmlTable table({{"run", "", false},
                   {"case", "", false},
                   {"integrator", "", false},
                   {"status", "", false},
                   {"unknowns"},
                   {"t reached [s]"},
                   {"steps"},
                   {"sweeps"},
                   {"CPU stepping [s]"},
                   {"memory [MB]"}},
                  true);
  for (const auto& [folder, run, curves, slice, motion] : runs)
    table.add_row({{.text = folder == "." ? "this folder" : folder},
                   {.text = run.title.empty() ? run.case_name : run.title},
                   {.text = spec_of(run), .kind = "strong", .hint = run.choice},
                   {.text = run.status, .kind = run.status == "ok" ? "good" : "bad", .hint = run.reason},
                   {.text = count_text(run.unknowns), .sort_key = fmt::format("{}", run.unknowns)},
                   number_cell(Number(run.t_reached)),
                   {.text = count_text(run.steps), .sort_key = fmt::format("{}", run.steps)},
                   {.text = count_text(run.rhs), .sort_key = fmt::format("{}", run.rhs)},
                   number_cell(Number(run.cpu_stepping)),
                   number_cell(Number(run.peak_memory_mb))});
  return table.html();
}

std::string notes_of(std::span<const RunInput> runs) {
  std::string out;
  for (const auto& run : runs) {
    const auto item = [&](const std::string& text) {
      out += fmt::format("<li><b>{}</b>: {}</li>\n", html_text(spec_of(run.record)), html_text(text));
    };
    if (!run.record.choice.empty()) item(run.record.choice);
    if (!run.record.reason.empty()) item(run.record.status + ": " + run.record.reason);
    for (const auto& warning : run.record.warnings) item("warning: " + warning);
    for (const auto& skip : run.record.skips)
      item(fmt::format("skipped: {} because {}", skip.what, skip.because));
  }
  return out.empty() ? "" : "<ul class=\"notes\">\n" + out + "</ul>\n";
}

std::string probe_figures(std::span<const RunInput> runs) {
  std::vector<ProbeCurve> curves;
  double end = 0;
  for (const auto& run : runs) {
    curves.insert(curves.end(), run.curves.begin(), run.curves.end());
    end = std::max(end, run.record.t_end);
  }
  const TimeUnit unit = time_unit(end);
  std::string out;
  std::size_t number = 0;
  for (const auto& panel : curve_panels(curves, "nu")) {
    const ProbeCurve& first = *panel.curves.front().curve;
    Chart chart{.id = fmt::format("runs-probe-{}", ++number),
                .title = panel.title,
                .caption = "",
                .x = {.label = fmt::format("time [{}]", unit.name)},
                .y = {.label = fmt::format("{} [{}]", first.field, first.unit)}};
    for (const auto& one : panel.curves) {
      ChartSeries series{.name = one.curve->spec, .look = one.look, .y = one.curve->value};
      for (const double t : one.curve->time) series.x.push_back(t * unit.factor);
      chart.series.push_back(std::move(series));
    }
    out += chart_figure(chart);
  }
  return figure_row(out);
}

}  // namespace

std::string runs_section(std::span<const RunInput> runs) {
  if (runs.empty()) return {};
  std::string pictures;
  for (const auto& run : runs) {  // one picture is enough: the fields of good runs look the same
    if (!run.slice) continue;
    pictures = packing_figures(*run.slice, "runs-packing");
    break;
  }
  return html_section("runs", "Runs", "Folders of superstep run.",
                      runs_table(runs) + notes_of(runs) + probe_figures(runs) + pictures);
}

}  // namespace superstep
