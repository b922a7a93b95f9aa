/// Published values beside ours (tables 1 to 4 of Rojek & Nisar 2026).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/chart.hpp"
#include "reports/html_parts.hpp"
#include "reports/html_text.hpp"
#include "reports/published.hpp"
#include "reports/sections.hpp"

namespace superstep {
namespace {

using Cell = HtmlTable::Cell;
using Json = nlohmann::ordered_json;

bool same(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::abs(b);
}

/// Our run with the same parameters; the baseline stands for forward Euler.
const BenchRow* our_run(const BenchCase& one, const PublishedRun& published) {
  for (const auto& row : one.rows) {
    if (published.nu == 0 && row.spec == one.baseline) return &row;
    const auto n = parameter(row, "n"), nu = parameter(row, "nu");
    if (row.integrator == "sts" && n && nu && same(*n, published.n) && same(*nu, published.nu)) return &row;
  }
  return nullptr;
}

Cell ratio_cell(const Number& ours, const Number& published) {
  if (!ours || !published || *published == 0) return {};
  return number_cell(Number(*ours / *published));
}

Cell name_cell(const PublishedRun& run) {
  if (run.nu == 0) return {.text = "forward Euler"};
  return {.text = fmt::format("ν = {}, N = {:.0f}", number_text(run.nu), run.n),
          .sort_key = fmt::format("{}", -run.nu * 1e6 + run.n)};
}

Number median(const std::optional<Timing>& timing) {
  return timing ? Number(timing->median) : std::nullopt;
}

std::string errors_table(const BenchCase& one, const PublishedCase& published, const CaseField& field) {
  HtmlTable table({{"run", "", false},
                   {fmt::format("mean error [{}], published", field.unit)},
                   {"ours"},
                   {"ours / published"},
                   {"decay k [1/s], published"},
                   {"ours"},
                   {"R², published"},
                   {"ours"}},
                  true);
  for (const auto& run : published.runs) {
    const BenchRow* row = our_run(one, run);
    const FieldErrors* errors = row ? field.errors(*row) : nullptr;
    if (!run.error_mean || !errors) continue;
    table.add_row({name_cell(run), number_cell(run.error_mean), number_cell(errors->probe_mean),
                   ratio_cell(errors->probe_mean, run.error_mean), number_cell(run.decay_rate),
                   number_cell(errors->decay_rate), number_cell(run.r2, 2),
                   number_cell(errors->decay_r2, 2)});
  }
  return table.empty() ? "" : "<h4>Error at the probe (" + published.error_table + ")</h4>\n" + table.html();
}

std::string performance_table(const BenchCase& one, const PublishedCase& published) {
  HtmlTable table({{"run", "", false},
                   {"substeps, published"},
                   {"ours"},
                   {"ours / published"},
                   {"CPU stepping [s], published"},
                   {"ours"},
                   {"speedup total, published"},
                   {"ours"},
                   {"speedup stepping, published"},
                   {"ours"}},
                  true);
  for (const auto& run : published.runs) {
    const BenchRow* row = our_run(one, run);
    if (!run.substeps || !row) continue;
    const Number sweeps = row->rhs ? Number(static_cast<double>(*row->rhs)) : std::nullopt;
    table.add_row({name_cell(run), number_cell(run.substeps, 7), number_cell(sweeps, 7),
                   ratio_cell(sweeps, run.substeps), number_cell(run.cpu_stepping, 5),
                   number_cell(median(row->cpu_stepping)), number_cell(run.speedup_total),
                   number_cell(row->speedup_total), number_cell(run.speedup_stepping),
                   number_cell(row->speedup_stepping)});
  }
  return table.empty() ? ""
                       : "<h4>Work and CPU time (" + published.performance_table + ")</h4>\n" + table.html();
}

std::string speedup_figure(const BenchCase& one, const PublishedCase& published, const std::string& id) {
  ChartSeries diagonal{.name = "equal", .look = {"#8a8a8a", "5 3", Marker::none}, .x = {1, 1}, .y = {1, 1}};
  ChartSeries runs{
      .name = "runs of super-time-stepping", .look = method_look("sts"), .kind = ChartSeries::Kind::points};
  for (const auto& run : published.runs) {
    const BenchRow* row = our_run(one, run);
    if (run.nu == 0 || !row || !run.speedup_stepping || !row->speedup_stepping) continue;
    runs.x.push_back(*run.speedup_stepping);
    runs.y.push_back(*row->speedup_stepping);
    runs.notes.push_back(fmt::format("ν = {}, N = {:.0f}: published {}, ours {}", number_text(run.nu), run.n,
                                     number_text(*run.speedup_stepping),
                                     number_text(*row->speedup_stepping)));
    diagonal.x[1] = diagonal.y[1] = std::max({diagonal.x[1], runs.x.back(), runs.y.back()});
  }
  if (runs.x.empty()) return {};
  return chart_figure({.id = id + "-paper-speedup",
                       .title = "Speedup of stepping, published and ours",
                       .caption = "On the line both are equal.",
                       .x = {.label = "published", .low = 0.0},
                       .y = {.label = "ours", .low = 0.0},
                       .series = {diagonal, runs}});
}

std::string error_figure(const BenchCase& one, const PublishedCase& published, const CaseField& field,
                         const std::string& id) {
  ChartSeries diagonal{.name = "equal", .look = {"#8a8a8a", "5 3", Marker::none}};
  ChartSeries runs{
      .name = "runs of super-time-stepping", .look = method_look("sts"), .kind = ChartSeries::Kind::points};
  for (const auto& run : published.runs) {
    const BenchRow* row = our_run(one, run);
    const FieldErrors* errors = row ? field.errors(*row) : nullptr;
    if (!errors || !run.error_mean || !errors->probe_mean) continue;
    runs.x.push_back(*run.error_mean);
    runs.y.push_back(*errors->probe_mean);
    runs.notes.push_back(fmt::format("ν = {}, N = {:.0f}: published {}, ours {}", number_text(run.nu), run.n,
                                     number_text(*run.error_mean), number_text(*errors->probe_mean)));
  }
  if (runs.x.empty()) return {};
  const double low = std::min(*std::min_element(runs.x.begin(), runs.x.end()),
                              *std::min_element(runs.y.begin(), runs.y.end()));
  const double high = std::max(*std::max_element(runs.x.begin(), runs.x.end()),
                               *std::max_element(runs.y.begin(), runs.y.end()));
  diagonal.x = diagonal.y = {low, high};
  return chart_figure(
      {.id = id + "-paper-error",
       .title = fmt::format("Mean error of the {} at the probe, published and ours", field.name),
       .caption = "On the line both are equal; below it ours is smaller.",
       .x = {.label = fmt::format("published [{}]", field.unit), .logarithmic = true},
       .y = {.label = fmt::format("ours [{}]", field.unit), .logarithmic = true},
       .series = {diagonal, runs}});
}

/// Figures of the sample that the case file quotes from the paper, with ours.
std::string sample_table(const std::optional<Json>& health) {
  if (!health || !health->contains("published")) return {};
  HtmlTable table({{"figure of the sample", "", false}, {"published"}, {"ours"}, {"ours / published"}},
                  false);
  for (const auto& [key, value] : health->at("published").items()) {
    if (!value.is_object() || !value.contains("published") || !value.at("published").is_number()) continue;
    std::string name = key;
    std::replace(name.begin(), name.end(), '_', ' ');
    const Number theirs = value.at("published").get<double>();
    const Number ours = value.contains("ours") && value.at("ours").is_number()
                            ? Number(value.at("ours").get<double>())
                            : std::nullopt;
    table.add_row({{.text = name}, number_cell(theirs, 5), number_cell(ours, 5), ratio_cell(ours, theirs)});
  }
  return table.empty() ? "" : "<h4>The sample</h4>\n" + table.html();
}

/// Ratio of ours to a published figure of the sample.
Number sample_ratio(const std::optional<Json>& health, const char* key) {
  if (!health || !health->contains("published") || !health->at("published").contains(key))
    return std::nullopt;
  const auto& value = health->at("published").at(key);
  if (!value.contains("ours") || !value.at("ours").is_number() || !value.at("published").is_number())
    return std::nullopt;
  return value.at("ours").get<double>() / value.at("published").get<double>();
}

std::string differences(const CaseInput& input) {
  std::vector<std::string> reasons = {
      "The sample is not the paper's: that one is not public, ours was generated to its published size, size "
      "distribution, density and conductivity."};
  if (const auto ratio = sample_ratio(input.health, "pair_step"))
    reasons.push_back(
        fmt::format("Substeps: the step rule is alpha times the smallest pairwise step, which is {} times "
                    "the published one in our "
                    "sample, so that about 1/{} = {} of the published number of steps is needed.",
                    number_text(*ratio), number_text(*ratio), number_text(1 / *ratio)));
  reasons.push_back(
      "CPU times differ with machine and code; speedups, being ratios on one machine, can be compared.");
  reasons.push_back(
      fmt::format("Errors: the paper compares with its own forward Euler run, we with a reference{} whose "
                  "error bar is known, so "
                  "that the error of forward Euler itself shows too.",
                  input.bench.reference ? " (" + input.bench.reference->spec + ")" : ""));
  reasons.push_back(
      "Decay rates: k and R² depend on the instants that enter the fit. We take every step end until the "
      "reference stays "
      "within 1 % of its final value; the paper takes output instants of a transient whose end it does not "
      "state. Early "
      "errors oscillate and late ones grow flat, so R² is low and k uncertain in both.");
  const bool natural = std::any_of(input.bench.rows.begin(), input.bench.rows.end(), [](const BenchRow& row) {
    return row.integrator == "sts" && row.params.find("order=natural") != std::string::npos;
  });
  if (!natural)
    reasons.push_back(
        "We carry the substeps out in Leja order, which keeps rounding small; the paper takes them from the "
        "longest to "
        "the shortest. In exact arithmetic both are the same superstep.");
  std::string out = "<h4>Why the numbers differ</h4>\n<ul>\n";
  for (const auto& reason : reasons) out += fmt::format("<li>{}</li>\n", html_text(reason));
  return out + "</ul>\n";
}

}  // namespace

std::string paper_section(const CaseInput& input, const std::string& id) {
  const auto published = published_case(input.bench.source);
  if (!published) return {};
  const auto fields = fields_of(input.bench);
  const auto field = std::find_if(fields.begin(), fields.end(),
                                  [&](const CaseField& one) { return one.name == published->field; });
  std::string tables = performance_table(input.bench, *published),
              figures = speedup_figure(input.bench, *published, id);
  if (field != fields.end()) {
    tables = errors_table(input.bench, *published, *field) + tables;
    figures += error_figure(input.bench, *published, *field, id);
  }
  if (tables.empty()) return {};
  return html_section(id + "-paper", "The paper side by side",
                      fmt::format("{}: published values beside those of this benchmark.", published->source),
                      sample_table(input.health) + tables + figure_row(figures) + differences(input));
}

}  // namespace superstep
