#include "results/study/stability_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "results/schema/stability_fields.hpp"

namespace superstep {
namespace {

template <class Row>
StabilityTable table_of(std::string name, const RecordFields<Row>& fields, const std::vector<Row>& rows) {
  StabilityTable table{std::move(name), {}, {}};
  for (const auto& field : fields) table.columns.push_back(field.name);
  for (const auto& row : rows) {
    auto& cells = table.rows.emplace_back();
    for (const auto& field : fields) cells.push_back(field.write(row));
  }
  return table;
}

std::string cell_text(const Json& value) {
  return value.is_boolean() ? value.get<bool>() ? "yes" : "no" : csv_cell_of_json(value);
}

}  // namespace

const char* grade_name(Verdict::Grade grade) {
  switch (grade) {
    case Verdict::Grade::safe:
      return "safe";
    case Verdict::Grade::careful:
      return "careful";
    case Verdict::Grade::unsafe:
      return "unsafe";
  }
  return "";
}

const char* stable_word(Tendency tendency) {
  switch (tendency) {
    case Tendency::decays:
      return "yes";
    case Tendency::grows:
      return "no";
    case Tendency::unclear:
      return "can not be told apart";
  }
  return "";
}

const char* verdict_name(FrozenLimit::Verdict verdict) {
  switch (verdict) {
    case FrozenLimit::Verdict::agrees:
      return "agrees";
    case FrozenLimit::Verdict::differs:
      return "differs";
    case FrozenLimit::Verdict::not_predicted:
      return "no prediction";
  }
  return "";
}

std::string StabilityTable::csv() const {
  std::string out = fmt::format("{}\n", fmt::join(columns, ","));
  for (const auto& row : rows) {
    std::vector<std::string> cells;
    cells.reserve(row.size());
    for (const auto& cell : row) cells.push_back(cell_text(cell));
    out += fmt::format("{}\n", fmt::join(cells, ","));
  }
  return out;
}

std::vector<StabilityTable> stability_tables(const StabilityResults& results) {
  return {table_of("methods", fields_of<MethodStability>(), results.methods),
          table_of("critical_step", fields_of<StepEstimate>(), results.critical_step.estimates),
          table_of("rounding", fields_of<RoundingGrowth>(), results.rounding),
          table_of("sweeps", sweep_columns(results.sweeps), results.sweeps),
          table_of("states", fields_of<FrozenRow>(), frozen_rows(results))};
}

std::string stability_json(const StabilityResults& results) {
  return json_file_text(schema_of_stability, stability_schema_version, results);
}

}  // namespace superstep
