#include "case/network/node_vector.hpp"

#include <fmt/format.h>

#include <unordered_map>
#include <utility>

#include "case/inputs/column_unit.hpp"
#include "case/inputs/named_column.hpp"
#include "core/error.hpp"
#include "core/text/bracketed_unit.hpp"
#include "core/text/ids_in_words.hpp"
#include "core/text/number.hpp"
#include "network/files/matrix_market.hpp"

namespace superstep {
namespace {

[[noreturn]] void wrong_length(const std::string& path, std::size_t found, std::size_t nodes) {
  throw InputError(
      fmt::format("{}: has {} values, and the network {} nodes; give one for each", path, found, nodes));
}

NodeVector of_matrix(const std::string& path, std::size_t nodes) {
  const MatrixMarket matrix = read_matrix_market(path);
  if (matrix.columns != 1 || matrix.rows != nodes) wrong_length(path, matrix.rows * matrix.columns, nodes);
  NodeVector out{std::vector<double>(nodes, 0.0), std::vector<char>(nodes, 0), !matrix.is_dense};
  for (const auto& entry : matrix.entries) {
    out.value[static_cast<std::size_t>(entry.row)] += entry.value;
    out.given[static_cast<std::size_t>(entry.row)] = 1;
  }
  return out;
}

/// Where ids and values stand: by their names where one is called id, else ids come first.
std::pair<std::size_t, std::size_t> columns_of_pairs(const DelimitedTable& table) {
  const auto& names = table.names();
  const auto is_id = [&](std::size_t k) { return lower_case(names[k]) == "id"; };
  if (names.empty() || is_id(0)) return {0, 1};
  if (is_id(1)) return {1, 0};
  throw InputError(fmt::format("{}: the header is '{}'; one of its two columns must be called id",
                               table.where_header(), table.first_text().substr(0, 120)));
}

/// Units in brackets, and those that end a name: "T_C".
void require_unit_of_values(const DelimitedTable& table, std::size_t column) {
  if (table.names().empty()) return;
  const std::string& name = table.names()[column];
  if (split_bracketed_unit(name).unit.empty())
    require_column_unit(name, {}, table.where_header());
  else
    require_plain_unit(name, table.where_header());
}

NodeVector of_column(DelimitedTable& table, const std::string& path, std::size_t nodes) {
  require_unit_of_values(table, 0);
  NodeVector out;
  while (table.next()) {
    const bool gap = lower_case(table.cells()[0]) == "nan";
    out.value.push_back(gap ? 0.0 : number_in(table, 0));
    out.given.push_back(gap ? 0 : 1);
  }
  if (out.value.size() != nodes) wrong_length(path, out.value.size(), nodes);
  return out;
}

NodeVector of_pairs(DelimitedTable& table, std::span<const std::int64_t> id) {
  std::unordered_map<std::int64_t, std::size_t> position;
  for (std::size_t k = 0; k < id.size(); ++k) position.emplace(id[k], k);
  NodeVector out{std::vector<double>(id.size(), 0.0), std::vector<char>(id.size(), 0)};
  const auto [id_column, value_column] = columns_of_pairs(table);
  require_unit_of_values(table, value_column);
  while (table.next()) {
    const auto number = parse_whole_number(table.cells()[id_column]);
    const auto found = number ? position.find(*number) : position.end();
    if (found == position.end())
      throw InputError(fmt::format("{}: id is {}; it must be a node of the network: {}", table.where(),
                                   in_quotes(table.cells()[id_column]), ids_in_words(id)));
    if (out.given[found->second])
      throw InputError(fmt::format("{}: id {} stands twice; keep one", table.where(), found->first));
    out.value[found->second] = number_in(table, value_column);
    out.given[found->second] = 1;
  }
  return out;
}

/// Of columns in a comment as well: "# id T_C".
HeaderRule vector_header() {
  return or_states_unit(
      header_of({"id", "value", "capacity", "source", "initial", "fixed", "temperature", "potential"}, 2),
      [](std::string_view name) { return split_column_unit(name).unit; });
}

}  // namespace

NodeVector read_node_vector(const std::string& path, std::span<const std::int64_t> id) {
  const std::string text = read_text_file(path);
  if (is_matrix_market(text)) return of_matrix(path, id.size());
  DelimitedTable table(path, text, vector_header());
  if (table.width() == 1) return of_column(table, path, id.size());
  if (table.width() == 2) return of_pairs(table, id);
  throw InputError(fmt::format(
      "{}: rows have {} columns; a value for each node is one column, or id and value, or a vector "
      "of the Matrix Market",
      table.where(), table.width()));
}

}  // namespace superstep
