#pragma once
/// Rows of tables of nodes and of edges, one after the other, or those of a part of a file.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/text/csv.hpp"
#include "core/text/rows_in_parts.hpp"

namespace superstep {

struct NodeRow {
  std::int64_t id = 0;
  double capacity = 0, source = 0, initial = 0;  ///< J/K or F, W or A, K or V
  std::optional<double> fixed = {};              ///< K or V
};

struct EdgeRow {
  std::int64_t i = 0, j = 0;  ///< ids
  double conductance = 0;     ///< W/K or S
};

[[nodiscard]] const std::vector<std::string>& node_columns();
[[nodiscard]] const std::vector<std::string>& edge_columns();

/// The next row of a table with these columns; false at the end. Throws InputError with file, line, value and
/// rule.
[[nodiscard]] bool next_row(CsvReader& rows, NodeRow& node);
[[nodiscard]] bool next_row(CsvReader& rows, EdgeRow& edge);

/// A table with these columns that says before its first row all that there is to know. Nothing where the
/// file is another one; `why_not` says then what it is. Throws InputError for a file that cannot be read, and
/// for a header that is wrong.
[[nodiscard]] std::optional<RowsInParts> open_rows(const std::string& path,
                                                   const std::vector<std::string>& columns,
                                                   std::string& why_not);

/// Rows that begin at bytes [first, last) of all. Throws InputError, whose line counts from the first of the
/// part.
[[nodiscard]] std::vector<NodeRow> nodes_of_part(const RowsInParts& table, std::uint64_t first,
                                                 std::uint64_t last);
[[nodiscard]] std::vector<EdgeRow> edges_of_part(const RowsInParts& table, std::uint64_t first,
                                                 std::uint64_t last);

}  // namespace superstep
