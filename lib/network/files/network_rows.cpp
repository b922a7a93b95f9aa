#include "network/files/network_rows.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/error.hpp"
#include "core/text/text_file.hpp"

namespace superstep {
namespace {

template <class Row>
std::vector<Row> rows_of_part(const RowsInParts& table, const std::vector<std::string>& columns,
                              std::uint64_t first, std::uint64_t last) {
  std::vector<Row> out;
  TableText text{table.path(), table.read(first, last)};
  if (text.content.empty()) return out;
  refuse_binary(text.content, text.path);
  CsvReader rows(std::move(text), columns);
  for (Row row; next_row(rows, row);) out.push_back(row);
  return out;
}

}  // namespace

const std::vector<std::string>& node_columns() {
  static const std::vector<std::string> columns{"id", "capacity", "source", "initial", "fixed"};
  return columns;
}

const std::vector<std::string>& edge_columns() {
  static const std::vector<std::string> columns{"i", "j", "conductance"};
  return columns;
}

bool next_row(CsvReader& rows, NodeRow& node) {
  enum : std::size_t { id, capacity, source, initial, fixed };
  if (!rows.next()) return false;
  node = {.id = rows.integer(id), .capacity = rows.number(capacity)};
  if (!(node.capacity >= 0))
    throw InputError(fmt::format("{}: capacity of node {} is {}; it must be >= 0 (J/K or F)", rows.where(),
                                 node.id, node.capacity));
  node.source = rows.number(source);
  node.initial = rows.number(initial);
  if (!rows.text(fixed).empty()) node.fixed = rows.number(fixed);
  return true;
}

bool next_row(CsvReader& rows, EdgeRow& edge) {
  enum : std::size_t { i, j, conductance };
  if (!rows.next()) return false;
  edge = {rows.integer(i), rows.integer(j), rows.number(conductance)};
  if (edge.i == edge.j)
    throw InputError(
        fmt::format("{}: edge {}-{} joins a node with itself; remove it", rows.where(), edge.i, edge.j));
  if (!(edge.conductance >= 0))
    throw InputError(fmt::format("{}: conductance {}-{} is {}; it must be finite and >= 0 (W/K or S)",
                                 rows.where(), edge.i, edge.j, edge.conductance));
  return true;
}

std::optional<RowsInParts> open_rows(const std::string& path, const std::vector<std::string>& columns,
                                     std::string& why_not) {
  auto rows = RowsInParts::open(path, why_not);
  if (!rows) return std::nullopt;
  CsvReader head({path, rows->head()}, columns);
  if (!head.next()) {
    why_not = "it has no rows";
    return std::nullopt;
  }
  rows->begin_rows_at(head.line());
  if (rows->has_header_line()) return rows;
  why_not = "no line of its own names its columns";
  return std::nullopt;
}

std::vector<NodeRow> nodes_of_part(const RowsInParts& table, std::uint64_t first, std::uint64_t last) {
  return rows_of_part<NodeRow>(table, node_columns(), first, last);
}

std::vector<EdgeRow> edges_of_part(const RowsInParts& table, std::uint64_t first, std::uint64_t last) {
  return rows_of_part<EdgeRow>(table, edge_columns(), first, last);
}

}  // namespace superstep
