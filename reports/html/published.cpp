#include "reports/html/published.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "core/text/number.hpp"
#include "core/text/text_file.hpp"
#include "reports/html/embedded.hpp"

namespace superstep {
namespace {

struct KnownCase {
  const char* source;
  const char* error_file;
  int error_table;
  const char* performance_file;
  const char* performance_table;
  const char* field;
};
constexpr KnownCase known_cases[] = {
    {"Rojek & Nisar 2026, section 9.1", "table1_temperature_error.csv", 1, "table2_thermal_performance.csv",
     "table 2", "temperature"},
    {"Rojek & Nisar 2026, section 9.2", "table3_potential_error.csv", 3,
     "table4_thermoelectric_performance.csv", "table 4", "potential"},
};

/// Cells of plain CSV without quotes, numbers only below the header.
std::vector<std::vector<double>> rows_of(std::string_view csv) {
  std::vector<std::vector<double>> rows;
  LineReader lines(csv);
  (void)lines.next();  // the header
  while (lines.next()) {
    if (trimmed(lines.line()).empty()) continue;
    auto& row = rows.emplace_back();
    for (std::string_view rest = lines.line(); !rest.empty();) {
      const std::size_t comma = std::min(rest.find(','), rest.size());
      const auto value = parse_number(trimmed(rest.substr(0, comma)));
      if (!value) throw std::logic_error("a published table holds something that is no number");
      row.push_back(*value);
      rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
  }
  return rows;
}

PublishedRun& run_of(std::vector<PublishedRun>& runs, double nu, double n) {
  for (auto& run : runs)
    if (run.nu == nu && run.n == n) return run;
  PublishedRun& run = runs.emplace_back();
  run.nu = nu;
  run.n = n;
  return run;
}

void read_measure(const KnownCase& known, PublishedCase& out) {
  for (const auto& row : rows_of(embedded_file("error_measures.csv"))) {
    if (row.at(0) != known.error_table) continue;
    out.measure = {.field = known.field,
                   .every = row.at(1),
                   .from = row.at(2),
                   .to = row.at(3),
                   .as_written = row.at(4) != 0};
    out.rate_times_ln10 = row.at(5) != 0;
    return;
  }
  throw std::logic_error("how a published table took its errors is missing");
}

PublishedCase read_case(const KnownCase& known) {
  PublishedCase out{.source = known.source,
                    .error_table = "table " + std::to_string(known.error_table),
                    .performance_table = known.performance_table,
                    .field = known.field,
                    .measure = {},
                    .runs = {}};
  read_measure(known, out);
  for (const auto& row : rows_of(embedded_file(known.performance_file))) {
    PublishedRun& run = run_of(out.runs, row.at(0), row.at(1));
    run.substeps = row.at(2);
    run.cpu_total = row.at(3);
    run.cpu_stepping = row.at(4);
    run.speedup_total = row.at(5);
    run.speedup_stepping = row.at(6);
  }
  for (const auto& row : rows_of(embedded_file(known.error_file))) {
    PublishedRun& run = run_of(out.runs, row.at(0), row.at(1));
    run.error_mean = row.at(2);
    run.decay_rate = row.at(3);
    run.r2 = row.at(4);
  }
  return out;
}

}  // namespace

std::optional<PublishedCase> published_case(const std::string& source) {
  for (const auto& known : known_cases)
    if (source == known.source) return read_case(known);
  return std::nullopt;
}

std::optional<SampledMeasure> published_measure(const std::string& source) {
  const auto known = published_case(source);
  return known ? std::optional(known->measure) : std::nullopt;
}

}  // namespace superstep
