#include "results/columns.hpp"

#include <algorithm>
#include <cmath>

namespace superstep {
namespace {

Cell number(const Number& value) {
  return value && std::isfinite(*value) ? Cell(*value) : Cell();
}
Cell count(const std::optional<std::uint64_t>& value) {
  return value ? Cell(*value) : Cell();
}
Cell count(std::size_t value) {
  return static_cast<std::uint64_t>(value);
}
Cell count(int value) {
  return static_cast<std::uint64_t>(value);
}
Cell median(const std::optional<Timing>& timing) {
  return timing ? number(timing->median) : Cell();
}

constexpr ErrorMeasure measures[] = {
    {"error_probe_mean", &FieldErrors::probe_mean},
    {"error_rms", &FieldErrors::rms},
    {"error_max", &FieldErrors::max},
    {"error_relative_rms", &FieldErrors::relative_rms},
    {"overshoot", &FieldErrors::overshoot},
    {"balance", &FieldErrors::balance},
    {"decay_rate", &FieldErrors::decay_rate},
    {"decay_r2", &FieldErrors::decay_r2},
    {"reference_error", &FieldErrors::reference_error},
    {"error_as_published", &FieldErrors::published_mean},
    {"decay_rate_as_published", &FieldErrors::published_rate},
    {"decay_r2_as_published", &FieldErrors::published_r2},
    {"span", &FieldErrors::span},
    {"delivered", &FieldErrors::delivered},
    {"distance_to_cvode", &FieldErrors::distance_to_cvode},
};
// `reference` stands before the reference's own error; what came later follows at the very end.
constexpr std::size_t later_columns = 6;
constexpr auto error_columns = std::span(measures).first<std::size(measures) - later_columns - 1>();
constexpr ErrorMeasure reference_error_column = measures[error_columns.size()];
constexpr auto later_error_columns = std::span(measures).last<later_columns>();

Column main_column(ErrorMeasure column) {
  return {column.name, [column](const BenchRow& row) { return number(row.errors.*column.value); }};
}

Column potential_column(ErrorMeasure column) {
  return {std::string(column.name) + "_potential", [column](const BenchRow& row) {
            return row.potential ? number((*row.potential).*column.value) : Cell();
          }};
}

bool any_twins(std::span<const BenchCase> cases) {
  return std::any_of(cases.begin(), cases.end(), [](const BenchCase& one) {
    return std::any_of(one.rows.begin(), one.rows.end(),
                       [](const BenchRow& row) { return row.potential.has_value(); });
  });
}

std::vector<Column> work_columns() {
  using Row = const BenchRow&;
  return {
      {"case", [](Row row) { return row.case_name; }},
      {"integrator", [](Row row) { return row.integrator; }},
      {"params", [](Row row) { return row.params; }},
      {"status", [](Row row) { return row.status; }},
      {"reason", [](Row row) { return row.reason; }},
      {"nodes", [](Row row) { return count(row.nodes); }},
      {"contacts", [](Row row) { return count(row.contacts); }},
      {"t_end", [](Row row) { return number(row.t_end); }},
      {"repetitions", [](Row row) { return count(row.repetitions); }},
      {"threads", [](Row row) { return count(row.threads); }},
      {"cpu_total_s", [](Row row) { return median(row.cpu_total); }},
      {"cpu_stepping_s", [](Row row) { return median(row.cpu_stepping); }},
      {"wall_stepping_s", [](Row row) { return median(row.wall_stepping); }},
      {"speedup_total", [](Row row) { return number(row.speedup_total); }},
      {"speedup_stepping", [](Row row) { return number(row.speedup_stepping); }},
      {"speedup_theory", [](Row row) { return number(row.speedup_theory); }},
      {"steps", [](Row row) { return count(row.steps); }},
      {"rejected", [](Row row) { return count(row.rejected); }},
      {"rhs", [](Row row) { return count(row.rhs); }},
      {"jacobians", [](Row row) { return count(row.jacobians); }},
      {"factorizations", [](Row row) { return count(row.factorizations); }},
      {"solves", [](Row row) { return count(row.solves); }},
      {"max_stages", [](Row row) { return count(row.max_stages); }},
      {"peak_memory_mb", [](Row row) { return number(row.peak_memory_mb); }},
  };
}

}  // namespace

std::span<const ErrorMeasure> error_measures() noexcept {
  return measures;
}

std::vector<Column> bench_columns(std::span<const BenchCase> cases) {
  std::vector<Column> columns = work_columns();
  for (const auto& column : error_columns) columns.push_back(main_column(column));
  columns.push_back({"reference", [](const BenchRow& row) { return row.reference; }});
  columns.push_back(main_column(reference_error_column));
  const bool twins = any_twins(cases);
  if (twins) {
    for (const auto& column : error_columns) columns.push_back(potential_column(column));
    columns.push_back(potential_column(reference_error_column));
  }
  for (const auto& column : later_error_columns) columns.push_back(main_column(column));
  for (const auto& column : later_error_columns)
    if (twins) columns.push_back(potential_column(column));
  columns.push_back({"cpu_prepare_s", [](const BenchRow& row) { return number(row.cpu_prepare); }});
  columns.push_back({"speedup_prepared", [](const BenchRow& row) { return number(row.speedup_prepared); }});
  columns.push_back({"cpu_pilot_s", [](const BenchRow& row) { return number(row.cpu_pilot); }});
  return columns;
}

}  // namespace superstep
