#include "audit/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <ostream>

namespace superstep::audit {
namespace {

void add(const Row& row, Tally& tally) {
  ++tally.runs;
  tally.sweeps += row.sweeps;
  if (row.status == "refused") ++tally.refused;
  if (row.status == "failed" || row.status == "unstable") ++tally.failed;
  if (row.status == "timeout") ++tally.too_long;
  if (row.error < 0) return;
  const bool ok = row.status == "ok";
  if (ok && row.error > 0.1) ++tally.far_off_ok;
  tally.errors.push_back(row.error);
  if (row.rtol == 0 || row.delivered < 0) return;
  ++tally.scored;
  tally.delivered.push_back(row.delivered);
  if (row.steps >= 10) tally.of_longer_runs.push_back(row.delivered);
  if (row.delivered < 2) ++tally.below_2;
  if (row.delivered < 3) ++tally.below_3;
  if (row.delivered > 5) ++tally.above_5;
  if (row.delivered > 10) ++tally.above_10;
  if (row.delivered > 10 && ok) ++tally.above_10_ok;
  if (row.floored) ++tally.floored;
}

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? std::numeric_limits<double>::quiet_NaN()
                    : static_cast<double>(part) / static_cast<double>(whole);
}

std::string number(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:.2g}", value);
}

void print_adaptive(std::ostream& out, const std::vector<Tally>& tallies) {
  out << fmt::format(
      "{:<31} {:>6} {:>5} {:>8} {:>6} {:>4} {:>8} {:>8} {:>8} {:>5} {:>5} {:>5} {:>6} {:>10}\n", "method",
      "rtol", "runs", "below 3", "> 10", "ok", "median", "95 %", "worst", "fail", "ref", "long", "trend",
      "sweeps");
  for (const auto& t : tallies) {
    if (t.rtol == 0) continue;
    out << fmt::format(
        "{:<31} {:>6.0e} {:>5} {:>8} {:>6} {:>4} {:>8} {:>8} {:>8} {:>5} {:>5} {:>5} {:>6} {:>10}\n", t.label,
        t.rtol, t.runs, percent(t.below_3, t.scored), t.above_10, t.above_10_ok,
        number(quantile(t.of_longer_runs, 0.5)), number(quantile(t.delivered, 0.95)),
        number(quantile(t.delivered, 1)), t.failed, t.refused, t.too_long, number(trend(tallies, t.label)),
        t.sweeps);
  }
}

void print_fixed(std::ostream& out, const std::vector<Tally>& tallies) {
  out << fmt::format("{:<31} {:>5} {:>8} {:>8} {:>8} {:>10} {:>5} {:>5} {:>5}\n", "fixed steps", "runs",
                     "median", "95 %", "worst", "ok > 10 %", "fail", "ref", "long");
  for (const auto& t : tallies) {
    if (t.rtol != 0) continue;
    out << fmt::format("{:<31} {:>5} {:>8} {:>8} {:>8} {:>10} {:>5} {:>5} {:>5}\n", t.label, t.runs,
                       number(quantile(t.errors, 0.5)), number(quantile(t.errors, 0.95)),
                       number(quantile(t.errors, 1)), t.far_off_ok, t.failed, t.refused, t.too_long);
  }
}

}  // namespace

std::string percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? "-" : fmt::format("{:.1f} %", 100 * share(part, whole));
}

std::vector<Tally> tally(const std::vector<Row>& rows, const std::string& kind) {
  std::vector<Tally> tallies;
  std::map<std::pair<std::string, double>, std::size_t> number;
  for (const auto& row : rows) {
    if (!kind.empty() && row.kind != kind) continue;
    const auto [entry, fresh] = number.try_emplace({row.label, row.rtol}, tallies.size());
    if (fresh) {
      tallies.emplace_back();
      tallies.back().label = row.label;
      tallies.back().rtol = row.rtol;
    }
    add(row, tallies[entry->second]);
  }
  for (auto& one : tallies)
    for (auto* values : {&one.delivered, &one.of_longer_runs, &one.errors})
      std::sort(values->begin(), values->end());
  return tallies;
}

double quantile(const std::vector<double>& ascending, double part) {
  if (ascending.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto last = static_cast<double>(ascending.size() - 1);
  return ascending[static_cast<std::size_t>(std::ceil(part * last))];
}

double trend(const std::vector<Tally>& tallies, const std::string& label) {
  // Fewer runs have no median to speak of.
  constexpr std::size_t enough = 8;
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const auto& t : tallies) {
    if (t.label != label || t.of_longer_runs.size() < enough) continue;
    low = std::min(low, quantile(t.of_longer_runs, 0.5));
    high = std::max(high, quantile(t.of_longer_runs, 0.5));
  }
  return high > 0 ? high / low : 1;
}

std::vector<std::string> broken_claims(const std::vector<Tally>& tallies) {
  std::vector<std::string> broken;
  for (const auto& t : tallies) {
    const std::string who = t.rtol > 0 ? fmt::format("{} at {:.0e}", t.label, t.rtol) : t.label;
    const auto claim = [&](bool holds, const std::string& what) {
      if (!holds) broken.push_back(who + ": " + what);
    };
    claim(t.far_off_ok == 0, fmt::format("{} runs ok with an error above 10 % of the span", t.far_off_ok));
    if (t.rtol == 0) continue;
    const Contender method{t.label};
    if (method.name() == "auto") {
      claim(!(share(t.below_2, t.scored) < 0.99),
            fmt::format("below 2 in {} only", percent(t.below_2, t.scored)));
      claim(t.above_5 == 0, fmt::format("{} runs above 5", t.above_5));
    }
    claim(!(share(t.below_3, t.scored) < 0.95),
          fmt::format("below 3 in {} only", percent(t.below_3, t.scored)));
    claim(static_cast<double>(t.above_10) <= std::max(1.0, 1e-3 * static_cast<double>(t.scored)),
          fmt::format("{} of {} runs above 10", t.above_10, t.scored));
    claim(t.above_10_ok == 0, fmt::format("{} runs above 10 are ok", t.above_10_ok));
    claim(!(share(t.failed + t.too_long, t.runs) > 0.02),
          fmt::format("{} of {} runs failed or took too long", t.failed + t.too_long, t.runs));
    if (!method.step_controlled() || t.of_longer_runs.size() < 8) continue;
    const double median = quantile(t.of_longer_runs, 0.5);
    claim(median >= 0.02 && median <= 1.5, fmt::format("median of longer runs {:.2g}", median));
    const double slope = trend(tallies, t.label);
    claim(slope <= 3, fmt::format("medians differ by {:.2g} over the tolerances", slope));
  }
  return broken;
}

void print_tables(std::ostream& out, const std::vector<Row>& rows, bool by_class) {
  const auto tallies = tally(rows);
  print_adaptive(out, tallies);
  out << '\n';
  print_fixed(out, tallies);
  out << '\n';
  const auto broken = broken_claims(tallies);
  out << (broken.empty() ? "All claims hold.\n" : "Claims that do not hold:\n");
  for (const auto& line : broken) out << "  " << line << '\n';
  if (!by_class) return;
  for (const auto& kind : scene_kinds()) {
    const auto of_kind = tally(rows, kind);
    if (of_kind.empty()) continue;
    out << '\n' << kind << '\n';
    print_adaptive(out, of_kind);
    print_fixed(out, of_kind);
  }
}

void print_bad(std::ostream& out, const std::vector<Row>& rows) {
  for (const auto& row : rows) {
    const bool bad = row.delivered > 10 || (row.status == "ok" && row.error > 0.1) ||
                     row.status == "failed" || row.status == "unstable" || row.status == "timeout";
    if (!bad) continue;
    out << fmt::format(
        "seed {} {} {} n={} t*lambda={:.2g}: {} rtol={:g} {} error {:.2g} delivered {:.3g} steps {} {}\n",
        row.seed, row.kind, row.shape, row.unknowns, row.t_lambda, row.label, row.rtol, row.status, row.error,
        row.delivered, row.steps, row.reason);
  }
  std::map<std::pair<std::string, std::string>, std::size_t> refusals;
  for (const auto& row : rows)
    if (row.status == "refused") ++refusals[{row.label, row.reason}];
  for (const auto& [who, count] : refusals)
    out << fmt::format("refused {} times: {}: {}\n", count, who.first, who.second);
}

}  // namespace superstep::audit
