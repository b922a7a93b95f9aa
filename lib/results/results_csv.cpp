#include "results/results_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/schema/bench_fields.hpp"

namespace superstep {
namespace {

template <class Text>
std::string line_of(const RecordFields<BenchRow>& columns, Text text) {
  std::vector<std::string> cells;
  cells.reserve(columns.size());
  for (const auto& column : columns) cells.push_back(text(column));
  return fmt::format("{}\n", fmt::join(cells, ","));
}

}  // namespace

std::string results_csv(std::span<const BenchCase> cases) {
  using Column = RecordField<BenchRow>;
  const auto columns = bench_columns(any_potential(cases));
  std::string out = line_of(columns, [](const Column& column) { return column.name; });
  for (const auto& one : cases)
    for (const auto& row : one.rows)
      out += line_of(columns, [&](const Column& column) { return csv_cell_of_json(column.write(row)); });
  return out;
}

}  // namespace superstep
