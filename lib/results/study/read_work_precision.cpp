#include "results/study/read_work_precision.hpp"

#include "core/error.hpp"
#include "core/text/number.hpp"
#include "core/text/options.hpp"
#include "results/text/csv_table.hpp"

namespace superstep {
namespace {

constexpr std::string_view error_prefix = "error_rms_at_";

std::uint64_t count(const CsvTable& table, std::size_t row, const char* column) {
  return table.count(row, table.column(column)).value_or(0);
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
  point.reason = table.text(row, table.column("reason"));
  point.sweeps = count(table, row, "sweeps");
  point.steps = count(table, row, "steps");
  if (const auto median = table.number(row, table.column("cpu_s")))
    point.cpu = Timing{*median, table.number(row, table.column("cpu_min_s")).value_or(*median),
                       table.number(row, table.column("cpu_max_s")).value_or(*median)};
  point.worst = table.number(row, table.column("error_worst")).value_or(0);
  point.worst_relative = table.number(row, table.column("error_worst_relative")).value_or(0);
  for (std::size_t c = 0; c < table.columns().size(); ++c)
    if (table.columns()[c].starts_with(error_prefix))
      if (const auto error = table.number(row, c)) point.error_rms.push_back(*error);
  return point;
}

}  // namespace

WorkPrecision read_work_precision_csv(const std::string& path) {
  const CsvTable table(path);
  WorkPrecision study;
  for (const auto& name : table.columns())
    if (name.starts_with(error_prefix))
      study.output_times.push_back(
          parse_number(std::string_view(name).substr(error_prefix.size())).value_or(0));
  for (std::size_t row = 0; row < table.rows(); ++row) study.points.push_back(point_of(table, row));
  if (table.rows() == 0) return study;
  study.case_name = table.text(0, table.column("case"));
  study.reference = table.text(0, table.column("reference"));
  study.reference_error = table.number(0, table.column("reference_error"));
  study.unknowns = count(table, 0, "unknowns");
  study.repetitions = static_cast<int>(count(table, 0, "repetitions"));
  study.threads = static_cast<int>(count(table, 0, "threads"));
  for (const auto& point : study.points)
    if (point.worst_relative > 0) study.span = point.worst / point.worst_relative;
  return study;
}

}  // namespace superstep
