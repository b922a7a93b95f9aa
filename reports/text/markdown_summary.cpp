#include "reports/text/markdown_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "core/text/quantity.hpp"
#include "reports/gate/timing_rule.hpp"
#include "results/same_case.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

constexpr double error_change = 0.01;  // relative; smaller ones are of no concern

/// Text that Markdown takes literally, in one line.
std::string markdown_text(const std::string& text) {
  std::string out;
  for (const char c : html_text(text)) {
    if (std::string_view("|*_`[]\\#").find(c) != std::string_view::npos) out += '\\';
    out += c == '\n' || c == '\t' ? ' ' : c;
  }
  return out;
}

const BenchRow* same_run(const BenchReport& report, const BenchRow& row) {
  for (const auto& one : report.cases)
    for (const auto& other : one.rows)
      if (other.case_name == row.case_name && other.spec == row.spec) return &other;
  return nullptr;
}

/// What became of one run.
struct Change {
  const BenchRow* row;
  enum class Kind { worse, better, other } kind = Kind::other;
  std::vector<std::string> what;
  bool times_can_tell = true;
};

void compare_counts(Change& change, const char* name, const std::optional<std::uint64_t>& now,
                    const std::optional<std::uint64_t>& before) {
  if (now && before && *now != *before) change.what.push_back(fmt::format("{} {} → {}", name, *before, *now));
}

/// Slower and faster are what they are to the gate; false = the times cannot tell.
bool compare_times(Change& change, const BenchRow& now, const BenchRow& before) {
  const auto times = in_one_unit(before.cpu_stepping_samples, before.yardstick_samples,
                                 now.cpu_stepping_samples, now.yardstick_samples);
  const auto timed = [](const PairedTimings& one) {
    return std::all_of(one.work.begin(), one.work.end(), [](double seconds) { return seconds > 0; });
  };
  if (!timed(times.before) || !timed(times.now) || doubt_about(times.before, times.now, timing_limits))
    return false;
  const RatioInterval ratio = slowdown(times.now, times.before);
  const bool slower = ratio.above(timing_limits.slower), faster = ratio.below(1 / timing_limits.slower);
  if (!slower && !faster) return true;
  change.what.push_back(fmt::format("CPU {} → {} s ({}×)", number_text(before.cpu_stepping->median),
                                    number_text(now.cpu_stepping->median), number_text(ratio.estimate)));
  change.kind = slower ? Change::Kind::worse : Change::Kind::better;
  return true;
}

/// Times are judged under the conditions of the gate.
bool same_machine(const BenchReport& now, const BenchReport& before) {
  const auto facts = [](const BenchReport& report) {
    std::vector<std::string> values = {fmt::format("{}", report.threads)};
    for (const auto& [name, value] : report.machine)
      if (name == "processor" || name == "flags") values.push_back(value);
    return values;
  };
  return facts(now) == facts(before);
}

Change compare(const BenchRow& now, const BenchRow& before, bool with_times) {
  Change change{.row = &now, .what = {}};
  if (with_times && now.cpu_stepping && before.cpu_stepping && now.processes == before.processes)
    change.times_can_tell = compare_times(change, now, before);
  compare_counts(change, "steps", now.steps, before.steps);
  compare_counts(change, "sweeps", now.rhs, before.rhs);
  if (now.errors.rms && before.errors.rms &&
      std::abs(*now.errors.rms - *before.errors.rms) > error_change * *before.errors.rms)
    change.what.push_back(
        fmt::format("rms error {} → {}", number_text(*before.errors.rms), number_text(*now.errors.rms)));
  if (now.status != before.status) {
    change.what.push_back(fmt::format("{} → {}", before.status, now.status));
    change.kind = now.ok() ? Change::Kind::better : Change::Kind::worse;
  }
  return change;
}

/// Of all runs, those that are as they were included.
std::vector<Change> changes_of(const BenchReport& report, const BenchReport& before, bool with_times) {
  std::vector<Change> changes;
  for (const auto& one : report.cases)
    for (const auto& old : before.cases)
      if (old.name == one.name) require_same_case(one, "", old, "");
  for (const auto& one : report.cases)
    for (const auto& row : one.rows) {
      const BenchRow* old = same_run(before, row);
      Change change = old ? compare(row, *old, with_times) : Change{.row = &row, .what = {"new"}};
      changes.push_back(std::move(change));
    }
  for (const auto& one : before.cases)
    for (const auto& row : one.rows)
      if (!same_run(report, row)) changes.push_back({&row, Change::Kind::other, {"gone"}});
  return changes;
}

std::string changes_markdown(const BenchReport& report, const BenchReport& before) {
  const bool with_times = same_machine(report, before);
  auto changes = changes_of(report, before, with_times);
  const bool all_told =
      std::all_of(changes.begin(), changes.end(), [](const Change& one) { return one.times_can_tell; });
  const std::string untold =
      !with_times ? "\nTimes are left out: processor, flags or threads are not those of before.\n"
      : all_told  ? ""
                  : "\nTimes that cannot tell are left out. " + timing_rule(timing_limits) + "\n";
  std::erase_if(changes, [](const Change& one) { return one.what.empty(); });
  const auto count = [&](Change::Kind kind) {
    return std::count_if(changes.begin(), changes.end(),
                         [&](const Change& change) { return change.kind == kind; });
  };
  const auto worse = count(Change::Kind::worse), better = count(Change::Kind::better);
  if (changes.empty()) return "**Unchanged.** No run differs from the benchmark before.\n" + untold;
  std::string out = fmt::format(
      "**{}** {} worse, {} better, {} otherwise changed.\n\n| case | run | what changed |\n|---|---|---|\n",
      worse > 0    ? "Worse."
      : better > 0 ? "Better."
                   : "Changed.",
      worse, better, count(Change::Kind::other));
  for (const auto& change : changes)
    out += fmt::format("| {} | {} | {} |\n", markdown_text(change.row->case_name),
                       markdown_text(change.row->spec),
                       markdown_text(fmt::format("{}", fmt::join(change.what, "; "))));
  return out + untold;
}

const BenchRow* fastest(const BenchCase& one) {
  const BenchRow* best = nullptr;
  for (const auto& row : one.rows)
    if (row.ok() && row.cpu_total && (!best || row.cpu_total->median < best->cpu_total->median)) best = &row;
  return best;
}

std::string case_markdown(const BenchCase& one) {
  const auto ok = std::count_if(one.rows.begin(), one.rows.end(), [](const auto& row) { return row.ok(); });
  std::string out =
      fmt::format("- {}: {} of {} succeeded", markdown_text(one.name), ok, quantity(one.rows.size(), "run"));
  if (const auto* best = fastest(one)) {
    out += fmt::format("; fastest {} with {} s CPU", markdown_text(best->spec),
                       number_text(best->cpu_total->median));
    if (best->speedup_total) out += fmt::format(", {}× the baseline", number_text(*best->speedup_total));
    if (best->errors.relative_rms)
      out += fmt::format(", error {} of the span", number_text(*best->errors.relative_rms));
  }
  out += "\n";
  for (const auto& row : one.rows)
    if (!row.ok())
      out += fmt::format("  - {}: {}: {}\n", markdown_text(row.spec), markdown_text(row.status),
                         markdown_text(row.reason));
  return out;
}

std::string verdict(const BenchReport& report) {
  std::size_t failed = 0, all = 0;
  for (const auto& one : report.cases)
    for (const auto& row : one.rows) {
      ++all;
      failed += row.ok() ? 0 : 1;
    }
  if (report.interrupted) return "**Interrupted.** What had been measured by then:\n\n";
  if (all == 0) return "**Nothing was measured.**\n";
  if (failed == 0 && all == 1) return "**The run succeeded.**\n\n";
  return failed == 0 ? fmt::format("**All {} runs succeeded.**\n\n", all)
                     : fmt::format("**{} of {} failed.**\n\n", failed, quantity(all, "run"));
}

}  // namespace

std::string markdown_summary(const BenchReport& report, const BenchReport* before) {
  if (before) return changes_markdown(report, *before);
  std::string out = verdict(report);
  for (const auto& one : report.cases) out += case_markdown(one);
  return out;
}

}  // namespace superstep
