#include "reports/gate/compare.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>

namespace superstep {
namespace {

std::optional<double> quotient(const MeasuredRow& a, const MeasuredRow& b, const std::string& column) {
  const auto before = a.number(column), now = b.number(column);
  if (!before || !now || !(*before > 0)) return std::nullopt;
  return *now / *before;
}

ComparedRow compare_rows(const std::string& case_name, const MeasuredRow& a, const MeasuredRow& b) {
  ComparedRow row{.case_name = case_name,
                  .spec = a.spec,
                  .status_a = a.status,
                  .status_b = b.status,
                  .time = {},
                  .doubt = {},
                  .in_yardsticks = false,
                  .work = quotient(a, b, "rhs"),
                  .error = quotient(a, b, "error_rms")};
  const auto [before, now, in_yardsticks] =
      in_one_unit(a.cpu_stepping, a.yardstick, b.cpu_stepping, b.yardstick);
  row.in_yardsticks = in_yardsticks;
  if (before.rounds() == 0 || now.rounds() == 0) return row;
  row.time = slowdown(now, before);
  if (const auto doubt = doubt_about(before, now, timing_limits)) row.doubt = doubt->kind;
  return row;
}

/// Cases, and methods of cases that both have, which stand in `here` only.
std::vector<std::string> only_in(const ResultsFile& here, const ResultsFile& there) {
  std::vector<std::string> names;
  for (const auto& one : here.cases) {
    const MeasuredCase* other = there.find(one.name);
    if (!other) names.push_back(fmt::format("case {}", one.name));
    for (const auto& row : one.rows)
      if (other && !other->find(row.spec)) names.push_back(fmt::format("`{}` on {}", row.spec, one.name));
  }
  return names;
}

/// Most that took part in a run: their CPU times are added up.
double processes_of(const ResultsFile& file) {
  double most = 1;
  for (const auto& one : file.cases)
    for (const auto& row : one.rows) most = std::max(most, row.number("processes").value_or(1));
  return most;
}

/// What the table does not show.
std::string below_the_table(const ResultsFile& a, const ResultsFile& b,
                            const std::vector<ComparedRow>& rows) {
  std::string out;
  const bool in_doubt = std::any_of(rows.begin(), rows.end(), [](const auto& row) { return row.doubt; });
  if (in_doubt) out += fmt::format("\n{}\n", timing_rule(timing_limits));
  for (const auto& [name, here, there] : {std::tuple("A", &a, &b), std::tuple("B", &b, &a)}) {
    if (here->interrupted) out += fmt::format("\n{} was interrupted.\n", name);
    if (const auto names = only_in(*here, *there); !names.empty())
      out += fmt::format("\nOnly in {}: {}.\n", name, fmt::join(names, ", "));
  }
  const auto note = [&](const char* what, const auto& one, const auto& other) {
    if (one != other) out += fmt::format("\nThe {} differ: '{}' and '{}'.\n", what, one, other);
  };
  note("processors", a.processor, b.processor);
  note("build flags", a.flags, b.flags);
  note("numbers of threads", a.threads, b.threads);
  note("numbers of processes", processes_of(a), processes_of(b));
  return out;
}

std::string shown(const std::optional<double>& ratio) {
  return ratio ? fmt::format("{:.4g}", *ratio) : "";
}

}  // namespace

const char* ComparedRow::words() const {
  if (status_a != status_b) return "not the same status";
  if (!time) return "not timed";
  if (doubt) switch (*doubt) {
      case TimingDoubt::Kind::too_few_rounds:
        return "too few rounds to tell";
      case TimingDoubt::Kind::too_short:
        return "too short to tell";
      case TimingDoubt::Kind::at_odds:
        return "too uneven to tell";
    }
  if (time->above(timing_limits.slower)) return "B is slower";
  if (time->below(1 / timing_limits.slower)) return "B is faster";
  return "no clear difference";
}

std::vector<ComparedRow> compare(const ResultsFile& a, const ResultsFile& b) {
  std::vector<ComparedRow> rows;
  for (const auto& one : a.cases) {
    const MeasuredCase* other = b.find_same(one, a.path);
    if (!other) continue;
    for (const auto& row : one.rows)
      if (const MeasuredRow* twin = other->find(row.spec)) rows.push_back(compare_rows(one.name, row, *twin));
  }
  return rows;
}

std::string compare_markdown(const ResultsFile& a, const ResultsFile& b,
                             const std::vector<ComparedRow>& rows) {
  std::string out =
      fmt::format("# Comparison\n\nA: `{}` ({}), B: `{}` ({}).", a.path, a.revision, b.path, b.revision);
  if (rows.empty())
    return out + "\n\nNothing to compare: they have no method on a case in common.\n" +
           below_the_table(a, b, rows);
  out +=
      " Ratios are B over A; CPU times of stepping, medians over rounds with 99 % intervals.\n\n"
      "| case | method | CPU | interval | unit | sweeps | error | |\n|---|---|---|---|---|---|---|---|\n";
  for (const auto& row : rows)
    out += fmt::format(
        "| {} | `{}` | {} | {} | {} | {} | {} | {} |\n", row.case_name, row.spec,
        row.time ? fmt::format("{:.3f}", row.time->estimate) : "",
        row.time && !row.doubt ? fmt::format("{:.3f} to {:.3f}", row.time->low, row.time->high) : "",
        row.in_yardsticks ? "yardsticks" : "seconds", shown(row.work), shown(row.error), row.words());
  return out + below_the_table(a, b, rows);
}

}  // namespace superstep
