#include "results/results_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "results/columns.hpp"
#include "results/text/csv_text.hpp"

namespace superstep {
namespace {

struct CellText {
  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(const std::string& text) const { return csv_cell(text); }
  std::string operator()(std::uint64_t value) const { return fmt::format("{}", value); }
  std::string operator()(double value) const { return csv_cell(value); }
};

template <class Text>
std::string line_of(const std::vector<Column>& columns, Text text) {
  std::vector<std::string> cells;
  cells.reserve(columns.size());
  for (const auto& column : columns) cells.push_back(text(column));
  return fmt::format("{}\n", fmt::join(cells, ","));
}

}  // namespace

std::string results_csv(std::span<const BenchCase> cases) {
  const auto columns = bench_columns(cases);
  std::string out = line_of(columns, [](const Column& column) { return column.name; });
  for (const auto& one : cases)
    for (const auto& row : one.rows)
      out += line_of(columns, [&](const Column& column) { return std::visit(CellText{}, column.cell(row)); });
  return out;
}

}  // namespace superstep
