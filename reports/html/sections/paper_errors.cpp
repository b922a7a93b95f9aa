/// Errors at the probe, published and ours (tables 1 and 3 of Rojek & Nisar 2026).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/median.hpp"
#include "reports/chart/chart.hpp"
#include "reports/html/sections/paper_parts.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

/// A published run with errors, and ours.
struct Pair {
  const PublishedRun* theirs;
  const BenchRow* row;
  const FieldErrors* ours;
};

std::vector<Pair> pairs(const BenchCase& one, const PublishedCase& published, const CaseField& field) {
  std::vector<Pair> out;
  for (const auto& run : published.runs) {
    const BenchRow* row = run.error_mean ? our_run(one, run) : nullptr;
    if (const FieldErrors* errors = row ? field.errors(*row) : nullptr) out.push_back({&run, row, errors});
  }
  return out;
}

Number median(std::vector<double> values) {
  return values.empty() ? std::nullopt : Number(median_of(std::move(values)));
}

/// What the printed decay rate says in 1/s.
Number true_rate(const PublishedCase& published, const PublishedRun& run) {
  if (!run.decay_rate || !published.rate_times_ln10) return run.decay_rate;
  return *run.decay_rate / std::numbers::ln10;
}

std::string time_text(double seconds) {
  return seconds < 1e-4 ? number_text(1e6 * seconds) + " µs" : number_text(1e3 * seconds) + " ms";
}

std::string rule_text(const SampledMeasure& rule) {
  const std::string instants =
      fmt::format("every {} from {} to {}", time_text(rule.every), time_text(rule.from), time_text(rule.to));
  if (rule.as_written)
    return fmt::format(
        "As published: {}, both codes write the state of their first step end at or after the instant, and "
        "forward Euler's value is subtracted from that of super-time-stepping as if both were of one moment. "
        "Most of that difference is the part of a superstep by which one is written later.",
        instants);
  return fmt::format(
      "As published: the error against the reference, {}; forward Euler, which the paper subtracts, differs "
      "from it by far less than any superstep.",
      instants);
}

/// Why printed decay rates are also shown divided by ln 10.
std::string rate_text(const std::vector<Pair>& all, const PublishedCase& published,
                      const Number& lambda_min) {
  if (!published.rate_times_ln10) return {};
  std::vector<double> printed, ratio;
  for (const auto& pair : all) {
    if (pair.theirs->decay_rate) printed.push_back(*pair.theirs->decay_rate);
    const Number rate = true_rate(published, *pair.theirs);
    if (rate && pair.ours->published_rate) ratio.push_back(*pair.ours->published_rate / *rate);
  }
  const Number typical = median(printed), agreement = median(ratio);
  if (!typical || !agreement) return {};
  std::string beyond;
  if (lambda_min && *typical > *lambda_min)
    beyond = fmt::format(
        " they exceed the published slowest rate of the network, {} 1/s, at which every error decays in the "
        "end, and",
        number_text(*lambda_min));
  return fmt::format(
      " Printed decay rates ({} 1/s in the median) are most likely ln 10 times too large, the factor applied "
      "twice:{} ours are {} of them as printed, {} of them divided by ln 10 (medians).",
      number_text(*typical), beyond, number_text(*agreement / std::numbers::ln10), number_text(*agreement));
}

std::string true_text(const CaseField& field) {
  return fmt::format(
      " True: the error of the {} against the reference at our own step ends, mean over the transient, "
      "fitted "
      "from its maximum on.",
      field.name);
}

}  // namespace

std::string paper_errors(const BenchCase& one, const PublishedCase& published, const CaseField& field,
                         const Number& lambda_min) {
  const auto all = pairs(one, published, field);
  if (all.empty()) return {};
  const bool two_readings = published.rate_times_ln10;
  std::vector<HtmlTable::Header> headers = {
      {"run", "", false},
      {fmt::format("mean error [{}], published", field.unit)},
      {"ours, as published", "by the rule of the published table, see above"},
      {"ours / published"},
      {"ours, true", "mean over the step ends of the transient, against the reference"},
      {"decay k [1/s], as printed"}};
  if (two_readings) headers.push_back({"printed / ln 10", "what was most likely meant"});
  headers.insert(headers.end(), {{"ours, as published"},
                                 {"ours / published", two_readings ? "to the printed one over ln 10" : ""},
                                 {"ours, true"},
                                 {"R², published"},
                                 {"ours, as published"}});
  HtmlTable table(std::move(headers), true);
  for (const auto& [theirs, row, ours] : all) {
    const Number rate = true_rate(published, *theirs);
    std::vector<HtmlTable::Cell> cells = {
        published_name(*theirs),           number_cell(theirs->error_mean),
        number_cell(ours->published_mean), ratio_cell(ours->published_mean, theirs->error_mean),
        number_cell(ours->probe_mean),     number_cell(theirs->decay_rate)};
    if (two_readings) cells.push_back(number_cell(rate));
    for (auto& cell :
         {number_cell(ours->published_rate), ratio_cell(ours->published_rate, rate),
          number_cell(ours->decay_rate), number_cell(theirs->r2, 2), number_cell(ours->published_r2, 2)})
      cells.push_back(cell);
    table.add_row(std::move(cells));
  }
  return fmt::format(
      "<h4>Error at the probe ({})</h4>\n<p>{}</p>\n{}", published.error_table,
      html_text(rule_text(published.measure) + true_text(field) + rate_text(all, published, lambda_min)),
      table.html());
}

std::string paper_error_figure(const BenchCase& one, const PublishedCase& published, const CaseField& field,
                               const std::string& id) {
  ChartSeries diagonal{.name = "equal", .look = {"#8a8a8a", "5 3", Marker::none}};
  ChartSeries as_published{
      .name = "as published", .look = method_look("sts"), .kind = ChartSeries::Kind::points};
  ChartSeries exact{.name = "true", .look = curve_look(1), .kind = ChartSeries::Kind::points};
  const auto add = [](ChartSeries& series, const Pair& pair, const Number& ours) {
    if (!ours) return;
    series.x.push_back(*pair.theirs->error_mean);
    series.y.push_back(*ours);
    series.notes.push_back(fmt::format("{}: published {}, ours {}", published_name(*pair.theirs).text,
                                       number_text(*pair.theirs->error_mean), number_text(*ours)));
  };
  for (const auto& pair : pairs(one, published, field)) {
    add(as_published, pair, pair.ours->published_mean);
    add(exact, pair, pair.ours->probe_mean);
  }
  Chart chart{.id = id + "-paper-error",
              .title = fmt::format("Mean error of the {} at the probe, published and ours", field.name),
              .caption = "On the line both are equal; below it ours is smaller.",
              .x = {.label = fmt::format("published [{}]", field.unit), .logarithmic = true},
              .y = {.label = fmt::format("ours [{}]", field.unit), .logarithmic = true}};
  std::vector<double> seen;
  for (const auto* series : {&as_published, &exact}) {
    if (series->x.empty()) continue;
    seen.insert(seen.end(), series->x.begin(), series->x.end());
    seen.insert(seen.end(), series->y.begin(), series->y.end());
  }
  if (seen.empty()) return {};
  const auto [low, high] = std::minmax_element(seen.begin(), seen.end());
  diagonal.x = diagonal.y = {*low, *high};
  chart.series = {diagonal};
  for (auto* series : {&as_published, &exact})
    if (!series->x.empty()) chart.series.push_back(std::move(*series));
  return chart_figure(chart);
}

}  // namespace superstep
