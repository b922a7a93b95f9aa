#include "results/results_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "core/text/quantity.hpp"
#include "results/answer.hpp"
#include "results/text/text_table.hpp"

namespace superstep {
namespace {

std::string text(const Number& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : std::string{};
}

std::string text(const std::optional<std::uint64_t>& value) {
  return value ? fmt::format("{}", *value) : "";
}

std::string error_text(const Number& error, const Number& bar) {
  if (error && bar && *error < *bar) return fmt::format("<{:.1e}", *bar);
  return text(error, "{:.2e}");
}

// Half the distance between the fastest and the slowest repetition, relative to the median.
std::string spread_text(const Timing& timing, int repetitions) {
  if (!(timing.median > 0) || repetitions < 2) return "";
  return fmt::format("{:.0f}%", 50 * (timing.max - timing.min) / timing.median);
}

TextTable::Cell status_cell(const BenchRow& row) {
  if (row.ok()) return {row.status, Style::green};
  return {row.status, row.status == "refused" ? Style::yellow : Style::red};
}

std::vector<TextTable::Cell> cells(const BenchRow& row, const std::string& baseline) {
  const auto& errors = row.errors;
  return {{row.spec, row.spec == baseline ? Style::bold : Style::plain},
          status_cell(row),
          {text(row.steps)},
          {text(row.rhs)},
          {row.cpu_stepping ? fmt::format("{:.3g}", row.cpu_stepping->median) : ""},
          {row.cpu_stepping ? spread_text(*row.cpu_stepping, row.repetitions) : ""},
          {text(row.cpu_prepare, "{:.2g}")},
          {text(row.speedup_stepping, "{:.3g}")},
          {text(row.speedup_theory, "{:.3g}")},
          {error_text(errors.probe_mean, errors.reference_error)},
          {error_text(errors.rms, errors.reference_error)},
          {text(errors.decay_rate, "{:.3g}")},
          {text(errors.decay_r2, "{:.3f}")}};
}

std::string heading(const BenchCase& one, int repetitions, int threads) {
  std::string out = one.name + (one.title.empty() ? "" : ": " + one.title) + "\n";
  out += fmt::format("{}, {}, {}, t_end {:g} s; {}, {}\n", quantity(one.nodes, "node"),
                     quantity(one.contacts, "contact"), quantity(one.unknowns, "unknown"), one.t_end,
                     quantity(repetitions, "repetition"), quantity(threads, "thread"));
  if (!one.reference) return out + "no reference: errors not measured\n";
  out += fmt::format("reference {}{}", one.reference->spec, one.reference->from_cache ? " (cached)" : "");
  for (const auto& row : one.rows) {
    if (!row.errors.reference_error) continue;
    out += fmt::format(", error bar {:.1e} {} rms", *row.errors.reference_error, one.unit);
    break;
  }
  return out + "\n";
}

// Rows that were not timed come last, in the order in which they were asked for.
std::vector<const BenchRow*> fastest_first(const BenchCase& one) {
  std::vector<const BenchRow*> rows;
  for (const auto& row : one.rows) rows.push_back(&row);
  std::stable_sort(rows.begin(), rows.end(), [](const BenchRow* a, const BenchRow* b) {
    constexpr double never = std::numeric_limits<double>::infinity();
    return prepared_cpu(*a).value_or(never) < prepared_cpu(*b).value_or(never);
  });
  return rows;
}

// What methods chose by themselves, and why others failed.
std::string notes_below(const BenchCase& one) {
  std::string out;
  for (const auto& row : one.rows) {
    if (!row.choice.empty()) out += fmt::format("  {}: {}\n", row.spec, row.choice);
    if (!row.reason.empty()) out += fmt::format("  {}: {}: {}\n", row.spec, row.status, row.reason);
  }
  return out;
}

}  // namespace

std::string results_table(const BenchCase& one, int repetitions, int threads, bool color) {
  using enum TextTable::Align;
  const std::string errors = fmt::format("error [{}]", one.unit), decay = "decay of error";
  TextTable table({{"", "integrator", left},
                   {"", "status", left},
                   {"work", "steps"},
                   {"work", "sweeps"},
                   {"CPU stepping", "median s"},
                   {"CPU stepping", "+-"},
                   {"CPU", "prepare s"},
                   {"speedup", "stepping"},
                   {"speedup", "theory"},
                   {errors, "probe"},
                   {errors, "rms"},
                   {decay, "k [1/s]"},
                   {decay, "R2"}});
  for (const auto* row : fastest_first(one)) table.add_row(cells(*row, one.baseline));
  std::string out =
      styled(heading(one, repetitions, threads), Style::plain, color) + "\n" + table.text(color);
  const std::string notes = notes_below(one), answer = answer_text(one);
  if (!notes.empty()) out += "\n" + notes;
  if (!answer.empty()) out += "\n" + answer + "\n";
  return out;
}

}  // namespace superstep
