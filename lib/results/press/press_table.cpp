#include "results/press/press_table.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "results/schema/press_table_fields.hpp"
#include "results/schema/record_csv.hpp"

namespace superstep {
namespace {

using Rows = std::span<const PressTableRow>;
using Place = double PressTableRow::*;

/// From each row to the next one of the same bed along `along`, all else being equal.
SpringbackTrend trend(Rows rows, Place fixed, Place along, bool upwards) {
  SpringbackTrend found;
  for (const auto& here : rows) {
    const PressTableRow* next = nullptr;
    for (const auto& other : rows) {
      const bool same =
          other.case_name == here.case_name && other.seed == here.seed && other.*fixed == here.*fixed;
      const auto before = [&](const PressTableRow& a, const PressTableRow& b) {
        return upwards ? a.*along < b.*along : a.*along > b.*along;
      };
      if (same && before(here, other) && (!next || before(other, *next))) next = &other;
    }
    if (!next || !here.ok() || !next->ok()) continue;
    ++found.pairs;
    found.less += *next->springback() < *here.springback() ? 1 : 0;
  }
  return found;
}

Number both(const Number& a, const Number& b, double (*of)(double a, double b)) {
  if (!a || !b) return std::nullopt;
  return of(*a, *b);
}

}  // namespace

Number PressTableRow::springback() const {
  return both(released, pressed, [](double r, double p) { return 1 - r / p; });
}

Number PressTableRow::porosity_drop() const {
  return both(released, poured, [](double r, double p) { return (r - p) / (1 - p); });
}

Number PressTableRow::porosity_points() const {
  return both(released, poured, [](double r, double p) { return r - p; });
}

std::vector<PressTableCell> press_table_cells(Rows rows) {
  std::map<std::tuple<std::string, double, double>, std::vector<const PressTableRow*>> beds;
  for (const auto& row : rows) {
    auto& found = beds[{row.case_name, row.upper_wall, row.hold}];
    if (row.ok()) found.push_back(&row);
  }
  std::vector<PressTableCell> cells;
  for (const auto& [place, found] : beds) {
    PressTableCell cell;
    std::tie(cell.case_name, cell.upper_wall, cell.hold) = place;
    cell.beds = found.size();
    const double part = 1.0 / static_cast<double>(std::max<std::size_t>(1, found.size()));
    for (const auto* row : found) {
      cell.springback += part * *row->springback();
      cell.drop += part * *row->porosity_drop();
      cell.points += part * *row->porosity_points();
      cell.poured += part * *row->poured;
      cell.pressed += part * *row->pressed;
      cell.cooling += part * (*row->temperature_hold - *row->temperature_end);
    }
    for (const auto* row : found)
      cell.spread = std::max(cell.spread, std::abs(*row->springback() - cell.springback));
    cells.push_back(cell);
  }
  return cells;
}

SpringbackTrend trend_with_hold(Rows rows) {
  return trend(rows, &PressTableRow::upper_wall, &PressTableRow::hold, true);
}

SpringbackTrend trend_with_densification(Rows rows) {
  return trend(rows, &PressTableRow::hold, &PressTableRow::upper_wall, false);
}

std::string press_table_csv(Rows rows) {
  const auto& columns = fields_of<PressTableRow>();
  std::string out = csv_header(columns);
  for (const auto& row : rows) out += csv_record(columns, row);
  return out;
}

std::vector<PressTableRow> read_press_table_csv(const std::string& path) {
  const CsvTable table(path);
  const auto& columns = fields_of<PressTableRow>();
  for (const char* needed : {"case", "seed", "upper_wall", "hold", "status"}) (void)table.column(needed);
  std::vector<PressTableRow> rows;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const Json json = json_of_row(columns, table, k);
    PressTableRow& row = rows.emplace_back();
    read_record(columns, row, JsonObject(path, json, "row " + std::to_string(k + 1)));
    const bool whole =
        row.poured && row.pressed && row.released && row.temperature_hold && row.temperature_end;
    if (row.ok() && !whole) table.reject(k, "it is ok, and numbers are missing; write the table anew");
  }
  return rows;
}

std::string press_table_json(Rows rows) {
  Json out = {{"schema", "superstep.press_table"}, {"schema_version", 1}, {"rows", Json::array()}};
  for (const auto& row : rows) out["rows"].push_back(write_record(fields_of<PressTableRow>(), row));
  return out.dump(2) + "\n";
}

}  // namespace superstep
