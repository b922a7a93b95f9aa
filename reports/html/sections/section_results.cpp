/// The answer in words, and the table of all runs.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text/quantity.hpp"
#include "reports/html/html_parts.hpp"
#include "reports/html/sections/sections.hpp"
#include "results/answer.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

using ResultCell = HtmlTable::Cell;
using Header = HtmlTable::Header;

std::string summary_words(const BenchCase& one) {
  const auto ok = std::count_if(one.rows.begin(), one.rows.end(), [](const auto& row) { return row.ok(); });
  std::string out = fmt::format("{} of {} succeeded.", ok, quantity(one.rows.size(), "run"));
  if (const std::string answer = answer_text(one); !answer.empty()) out = answer + " " + out;
  if (!one.reference) out += " No reference: how accurate the methods are was not measured.";
  return out;
}

/// What the sweep over all methods says, at an error that is common in practice.
std::string sweep_words(const WorkPrecision& study) {
  constexpr double common = 1e-3;
  for (const auto& level : winners(study))
    if (level.winner && std::abs(level.level - common) < 1e-9)
      return fmt::format(
          " In the sweep over all methods below, {} is the fastest that keeps an error of {} of the span.",
          level.winner->spec, number_text(common, 1));
  return {};
}

// One line per accuracy that some run of the benchmark reaches.
std::string accuracy_table(const BenchCase& one) {
  HtmlTable table({{"error allowed, relative to the field's span", "", false},
                   {"fastest run that keeps it", "", false},
                   {"CPU, preparation and stepping [s]"},
                   {"speedup over the baseline"},
                   {"its error"}},
                  false);
  for (const double level : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const auto* row = fastest_within(one, level);
    if (!row) break;
    table.add_row({{.text = number_text(level, 1)},
                   {.text = row->spec, .kind = "strong"},
                   number_cell(prepared_cpu(*row)),
                   number_cell(row->speedup_prepared),
                   number_cell(relative_error(*row))});
  }
  return table.empty() ? "" : table.html();
}

ResultCell error_cell(const Number& error, const Number& bar) {
  if (error && bar && *error < *bar)
    return {.text = "< " + number_text(*bar, 2),
            .sort_key = fmt::format("{}", *error),
            .kind = "dim",
            .hint = "below the error bar of the reference"};
  return number_cell(error);
}

std::vector<Header> headers_of(const std::vector<CaseField>& fields) {
  std::vector<Header> headers = {{"integrator", "", false},
                                 {"status", "", false},
                                 {"steps", "accepted steps; supersteps for STS"},
                                 {"sweeps", "passes over the network"},
                                 {"CPU total [s]", "reading, preparation and stepping; median"},
                                 {"CPU stepping [s]", "integration only; median"},
                                 {"±", "half the range of the repetitions over the median"},
                                 {"speedup total", "CPU total of the baseline over this one"},
                                 {"speedup stepping", "CPU stepping of the baseline over this one"},
                                 {"theory", "speedup that the published formula promises"}};
  for (const auto& field : fields) {
    const std::string of = fields.size() > 1 ? field.name + ": " : "";
    headers.push_back(
        {fmt::format("{}rms error [{}]", of, field.unit), "over all free nodes, worst output time"});
    headers.push_back({fmt::format("{}max error [{}]", of, field.unit), "worst node, worst output time"});
    headers.push_back({of + "relative rms", "rms error over the span of the field"});
    headers.push_back(
        {fmt::format("{}probe error [{}]", of, field.unit), "mean over the transient, at the probe"});
    headers.push_back({of + "decay k [1/s]", "error at the probe = Z exp(-k t)"});
    headers.push_back({of + "R²", "of that fit"});
    headers.push_back({fmt::format("{}overshoot [{}]", of, field.unit),
                       "beyond the range that the maximum principle allows"});
  }
  headers.push_back({"balance", "(heat entered - heat stored) / heat entered"});
  headers.push_back({"memory [MB]", "largest resident set during its run"});
  return headers;
}

ResultCell status_cell(const BenchRow& row) {
  return {.text = row.status, .kind = row.ok() ? "good" : "bad", .hint = row.reason};
}

std::vector<ResultCell> cells_of(const BenchRow& row, const BenchCase& one,
                                 const std::vector<CaseField>& fields) {
  const auto median = [](const std::optional<Timing>& timing) {
    return timing ? Number(timing->median) : Number();
  };
  const auto count = [](const std::optional<std::uint64_t>& value) {
    return value ? ResultCell{.text = count_text(*value), .sort_key = fmt::format("{}", *value)}
                 : ResultCell{};
  };
  ResultCell spread;
  if (row.cpu_stepping && row.cpu_stepping->median > 0) {
    const double share = 50 * (row.cpu_stepping->max - row.cpu_stepping->min) / row.cpu_stepping->median;
    spread = {.text = fmt::format("{:.0f} %", share), .sort_key = fmt::format("{}", share)};
  }
  std::vector<ResultCell> cells = {
      {.text = row.spec, .kind = row.spec == one.baseline ? "strong" : "", .hint = row.choice},
      status_cell(row),
      count(row.steps),
      count(row.rhs),
      number_cell(median(row.cpu_total)),
      number_cell(median(row.cpu_stepping)),
      spread,
      number_cell(row.speedup_total),
      number_cell(row.speedup_stepping),
      number_cell(row.speedup_theory)};
  for (const auto& field : fields) {
    static const FieldErrors nothing;
    const FieldErrors& e = field.errors(row) ? *field.errors(row) : nothing;
    cells.push_back(error_cell(e.rms, e.reference_error));
    cells.push_back(error_cell(e.max, e.reference_error));
    cells.push_back(number_cell(e.relative_rms));
    cells.push_back(error_cell(e.probe_mean, e.reference_error));
    cells.push_back(number_cell(e.decay_rate));
    cells.push_back(number_cell(e.decay_r2));
    cells.push_back(number_cell(e.overshoot));
  }
  cells.push_back(number_cell(row.errors.balance));
  cells.push_back(number_cell(row.peak_memory_mb));
  return cells;
}

// What methods chose by themselves, and why others failed.
std::string notes_below(const BenchCase& one) {
  std::string out;
  for (const auto& row : one.rows) {
    if (!row.choice.empty())
      out += fmt::format("<li><b>{}</b>: {}</li>\n", html_text(row.spec), html_text(row.choice));
    if (!row.reason.empty())
      out += fmt::format("<li class=\"bad\"><b>{}</b>: {}: {}</li>\n", html_text(row.spec),
                         html_text(row.status), html_text(row.reason));
  }
  return out.empty() ? "" : "<ul class=\"notes\">\n" + out + "</ul>\n";
}

}  // namespace

std::string answer_section(const CaseInput& input, const std::string& id) {
  const BenchCase& one = input.bench;
  if (one.rows.empty())
    return html_section(id + "-answer", "The answer", "", "<p>No run was measured.</p>\n");
  const std::string table = accuracy_table(one);
  const std::string words =
      summary_words(one) + (input.work_precision ? sweep_words(*input.work_precision) : "");
  return html_section(id + "-answer", "The answer", "",
                      fmt::format("<p class=\"lead\">{}</p>\n{}", sentence_html(words), table));
}

std::string results_section(const CaseInput& input, const std::string& id) {
  const BenchCase& one = input.bench;
  if (one.rows.empty()) return {};
  const auto fields = fields_of(one);
  HtmlTable table(headers_of(fields), true);
  for (const auto& row : one.rows) table.add_row(cells_of(row, one, fields));
  const std::string bar =
      !one.rows.front().errors.reference_error
          ? ""
          : fmt::format(" Error bar of the reference: {} {} rms.",
                        number_text(*one.rows.front().errors.reference_error, 2), one.unit);
  return html_section(id + "-results", "All runs",
                      "One line per run; point at a heading to see what it means, click it to sort." + bar,
                      table.html() + notes_below(one));
}

}  // namespace superstep
