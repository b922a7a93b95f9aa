#include "results/study/read_work_precision.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "core/text/number.hpp"
#include "core/text/options.hpp"
#include "core/text/text_file.hpp"
#include "results/schema/bench_fields.hpp"
#include "results/text/csv_table.hpp"

namespace superstep {
namespace {

constexpr std::string_view error_prefix = "error_rms_at_";

std::uint64_t count(const CsvTable& table, std::size_t row, const char* column) {
  return table.count(row, table.column(column)).value_or(0);
}

/// A number that no measurement makes negative.
Number amount(const CsvTable& table, std::size_t row, std::string_view column) {
  const std::size_t at = table.column(column);
  const auto number = table.number(row, at);
  if (number && *number < 0) table.reject(row, fmt::format("column '{}' must not be negative", column));
  return number;
}

/// What the winners are found from: a method that is ok has all of it.
void require_measured(const CsvTable& table, std::size_t row) {
  for (std::size_t c = 0; c < table.columns().size(); ++c)
    if (const auto& name = table.columns()[c];
        name == "cpu_s" || name.starts_with("error_worst") || name.starts_with(error_prefix))
      if (!table.number(row, c))
        table.reject(row, fmt::format("its status is ok, and column '{}' is empty", name));
}

WorkPrecisionPoint point_of(const CsvTable& table, std::size_t row) {
  WorkPrecisionPoint point;
  point.integrator = table.text(row, table.column("integrator"));
  point.params = table.text(row, table.column("params"));
  point.spec = point.integrator + (point.params.empty() ? "" : ":" + point.params);
  try {
    point.family = family_of(parse_spec(point.spec));
  } catch (const UsageError& error) {  // nobody typed it: it is the file that has to be mended
    table.reject(row, error.what());
  }
  point.status = table.text(row, table.column("status"));
  if (const auto& known = statuses(); std::find(known.begin(), known.end(), point.status) == known.end())
    table.reject(row, fmt::format("its status is {}, and must be one of {}", in_quotes(point.status),
                                  fmt::join(known, ", ")));
  if (point.ok()) require_measured(table, row);
  point.reason = table.text(row, table.column("reason"));
  point.sweeps = count(table, row, "sweeps");
  point.steps = count(table, row, "steps");
  if (const auto median = amount(table, row, "cpu_s"))
    point.cpu = Timing{*median, amount(table, row, "cpu_min_s").value_or(*median),
                       amount(table, row, "cpu_max_s").value_or(*median)};
  point.worst = amount(table, row, "error_worst").value_or(0);
  point.worst_relative = amount(table, row, "error_worst_relative").value_or(0);
  for (const auto& name : table.columns())
    if (name.starts_with(error_prefix))
      if (const auto error = amount(table, row, name)) point.error_rms.push_back(*error);
  if (const auto& errors = point.error_rms;
      !errors.empty() && *std::max_element(errors.begin(), errors.end()) != point.worst)
    table.reject(row, "column 'error_worst' is not the largest of the errors at output times");
  return point;
}

std::vector<double> output_times_of(const CsvTable& table, const std::string& path) {
  std::vector<double> times;
  for (const auto& name : table.columns()) {
    if (!name.starts_with(error_prefix)) continue;
    const auto time = parse_number(std::string_view(name).substr(error_prefix.size()));
    if (!time || *time < 0 || (!times.empty() && *time <= times.back()))
      throw InputError(fmt::format(
          "{}: column {} must name an output time, in seconds and after that of the column before; "
          "write the file anew",
          path, in_quotes(name)));
    times.push_back(*time);
  }
  if (times.empty())
    throw InputError(
        fmt::format("{}: there is no column '{}T' of errors at an output time T; write the file anew", path,
                    error_prefix));
  return times;
}

}  // namespace

WorkPrecision read_work_precision_csv(const std::string& path) {
  const CsvTable table(path);
  WorkPrecision study;
  study.output_times = output_times_of(table, path);
  std::set<std::string> methods;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    study.points.push_back(point_of(table, row));
    if (!methods.insert(study.points.back().spec).second)
      table.reject(row, fmt::format("an earlier row is of {}, too", study.points.back().spec));
    for (const char* fact : {"case", "reference"})  // of the whole sweep
      if (table.text(row, table.column(fact)) != table.text(0, table.column(fact)))
        table.reject(row, fmt::format("its {} is not that of the first row", fact));
  }
  if (table.rows() == 0) return study;
  study.case_name = table.text(0, table.column("case"));
  study.reference = table.text(0, table.column("reference"));
  study.reference_error = amount(table, 0, "reference_error");
  study.unknowns = count(table, 0, "unknowns");
  study.repetitions = static_cast<int>(count(table, 0, "repetitions"));
  study.threads = static_cast<int>(count(table, 0, "threads"));
  for (const auto& point : study.points)
    if (point.worst_relative > 0) study.span = point.worst / point.worst_relative;
  return study;
}

}  // namespace superstep
