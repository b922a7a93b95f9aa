#include "packing/parts/table_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/text/delimited.hpp"
#include "packing/formats/columns/columns.hpp"
#include "packing/formats/columns/known_names.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/stated.hpp"

namespace superstep {

std::optional<TableInParts> TableInParts::open(const std::string& path, const PackingOptions& options,
                                               std::string& why_not) {
  const auto is_other = [&](const char* what) {
    why_not = what;
    return std::nullopt;
  };
  auto rows = RowsInParts::open(path, why_not);
  if (!rows) return std::nullopt;
  const std::string text = rows->head();
  if (!is_table(path, text, options)) return is_other("it is no table such as CSV");
  const PackingFile file{
      .path = path, .content = text, .options = options, .stated = stated_length_unit(path, text)};
  if (stated_cell(file) || options.box) return is_other("it has a box");
  DelimitedTable table(path, text, sphere_header_rule());
  if (table.names().empty() && options.columns.empty()) return is_other("its columns have no names");
  if (!table.next()) return is_other("it has no rows");
  const auto& names = options.columns.empty() ? table.names() : options.columns;
  const SphereColumns columns = find_sphere_columns(names, {}, path, "the header");
  if (columns.material != SphereColumns::none) return is_other("it has a column of materials");
  if (std::any_of(names.begin(), names.end(), names_a_time)) return is_other("it has a column of time");
  TableInParts parts;
  parts.options_ = options;
  parts.has_ids_ = columns.id != SphereColumns::none;
  rows->begin_rows_at(table.line());
  const std::size_t row = rows->head().size();
  parts.rows_ = std::move(*rows);
  // The first row alone says what the rest says of units.
  const std::size_t row_end = std::min(text.find('\n', row), text.size());
  parts.length_unit_ = read_table(path, text.substr(0, row_end), options).length_unit;
  return parts;
}

Packing TableInParts::read(std::uint64_t first, std::uint64_t last) const {
  const std::string text = rows_.read(first, last);
  if (text.empty()) return {};
  Packing packing = read_table(path(), text, options_);
  packing.attributes.clear();
  packing.text_columns.clear();
  return packing;
}

}  // namespace superstep
