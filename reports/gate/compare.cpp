#include "reports/gate/compare.hpp"

#include <fmt/format.h>

namespace superstep {
namespace {

constexpr double worth_a_word = 1.02;  // two runs of one program differ by less only by luck

std::optional<double> quotient(const MeasuredRow& a, const MeasuredRow& b, const std::string& column) {
  const auto before = a.number(column), now = b.number(column);
  if (!before || !now || !(*before > 0)) return std::nullopt;
  return *now / *before;
}

/// CPU times in yardsticks when both have them, else in seconds.
bool take_timings(const MeasuredRow& a, const MeasuredRow& b, PairedTimings& first, PairedTimings& second) {
  const auto has_yardstick = [](const MeasuredRow& row) {
    return row.yardstick.size() == row.cpu_stepping.size();
  };
  const bool in_yardsticks = has_yardstick(a) && has_yardstick(b);
  const auto timings = [&](const MeasuredRow& row) {
    return PairedTimings{row.cpu_stepping,
                         in_yardsticks ? row.yardstick : std::vector<double>(row.cpu_stepping.size(), 1.0)};
  };
  first = timings(a);
  second = timings(b);
  return in_yardsticks;
}

ComparedRow compare_rows(const std::string& case_name, const MeasuredRow& a, const MeasuredRow& b) {
  ComparedRow row{.case_name = case_name,
                  .spec = a.spec,
                  .status_a = a.status,
                  .status_b = b.status,
                  .time = {},
                  .in_yardsticks = false,
                  .work = quotient(a, b, "rhs"),
                  .error = quotient(a, b, "error_rms")};
  PairedTimings first, second;
  row.in_yardsticks = take_timings(a, b, first, second);
  if (first.rounds() > 1 && second.rounds() > 1) row.time = slowdown(second, first);
  return row;
}

std::string shown(const std::optional<double>& ratio) {
  return ratio ? fmt::format("{:.4g}", *ratio) : "";
}

}  // namespace

const char* ComparedRow::words() const {
  if (status_a != status_b) return "not the same status";
  if (!time) return "not timed";
  if (time->above(worth_a_word)) return "B is slower";
  if (time->below(1 / worth_a_word)) return "B is faster";
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
  std::string out = fmt::format(
      "# Comparison\n\nA: `{}` ({}), B: `{}` ({}). Ratios are B over A; CPU times of stepping, medians over "
      "rounds with 99 % intervals.\n\n"
      "| case | method | CPU | interval | unit | sweeps | error | |\n|---|---|---|---|---|---|---|---|\n",
      a.path, a.revision, b.path, b.revision);
  for (const auto& row : rows)
    out += fmt::format("| {} | `{}` | {} | {} | {} | {} | {} | {} |\n", row.case_name, row.spec,
                       row.time ? fmt::format("{:.3f}", row.time->estimate) : "",
                       row.time ? fmt::format("{:.3f} to {:.3f}", row.time->low, row.time->high) : "",
                       row.in_yardsticks ? "yardsticks" : "seconds", shown(row.work), shown(row.error),
                       row.words());
  if (a.processor != b.processor)
    out += fmt::format("\nThe processors differ: '{}' and '{}'.\n", a.processor, b.processor);
  return out;
}

}  // namespace superstep
