#pragma once
/// Records as lines of CSV, from the one list of their fields.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <string>
#include <vector>

#include "results/schema/record_field.hpp"
#include "results/text/csv_table.hpp"

namespace superstep {

/// One line; `text` gives the cell of a column.
template <class Record, class Text>
[[nodiscard]] std::string csv_line(const RecordFields<Record>& columns, Text text) {
  std::vector<std::string> cells;
  cells.reserve(columns.size());
  for (const auto& column : columns) cells.push_back(text(column));
  return fmt::format("{}\n", fmt::join(cells, ","));
}

template <class Record>
[[nodiscard]] std::string csv_header(const RecordFields<Record>& columns) {
  return csv_line(columns, [](const auto& column) { return column.name; });
}
template <class Record>
[[nodiscard]] std::string csv_record(const RecordFields<Record>& columns, const Record& record) {
  return csv_line(columns, [&](const auto& column) { return csv_cell_of_json(column.write(record)); });
}

/// A row of a table as the object that the fields of a record read: texts where their schema says so, else
/// numbers. Columns that the table lacks, and empty cells of numbers, are null.
template <class Record>
[[nodiscard]] Json json_of_row(const RecordFields<Record>& columns, const CsvTable& table, std::size_t row) {
  Json out = Json::object();
  for (const auto& column : columns) {
    const auto at = table.find(column.name);
    const Json type = column.schema.at("type");
    if (!at)
      out[column.name] = nullptr;
    else if (type == "string")
      out[column.name] = table.text(row, *at);
    else if (const auto number = table.number(row, *at); !number)
      out[column.name] = nullptr;
    else if (type == "integer" && *number >= 0 && *number < 0x1p53 && *number == std::floor(*number))
      out[column.name] =
          static_cast<std::uint64_t>(*number);  // what is no count is refused by the reader of the record
    else
      out[column.name] = *number;
  }
  return out;
}

}  // namespace superstep
