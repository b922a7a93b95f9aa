/// CSV and other tables of particles, with a header or without.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "core/error.hpp"
#include "core/text/delimited.hpp"
#include "core/text/number.hpp"
#include "packing/formats/columns/columns.hpp"
#include "packing/formats/columns/declared.hpp"
#include "packing/formats/columns/known_names.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/sphere_rows.hpp"
#include "packing/formats/stated.hpp"

namespace superstep {
namespace {

bool all_numbers(const std::vector<std::string_view>& cells) {
  return std::all_of(cells.begin(), cells.end(), [](auto cell) { return parse_number(cell).has_value(); });
}

/// True where a comment names positions: rows below it may hold words.
bool comment_names_a_position(const PackingFile& file) {
  try {
    return names_a_position(DelimitedTable(file.path, file.content, sphere_header_rule()).names());
  } catch (const InputError&) {
    return true;  // of half a header, which is said when the table is read
  }
}

/// Nearly every text with a delimiter is a table, so that what is wrong with it can be said; one whose cells
/// stand between blanks must look like numbers, or name positions.
bool recognises(const PackingFile& file) {
  if (!file.is_text) return false;
  std::vector<std::string_view> cells;
  LineReader lines(file.content);
  while (lines.next() && is_comment_or_blank(lines.line())) {
  }
  if (stated_delimiter(lines.line()) != '\0') return true;
  const char delimiter = delimiter_of(lines.line());
  if (!split_cells(lines.line(), delimiter, cells)) return delimiter != ' ';
  if (delimiter != ' ') return cells.size() > 1;
  constexpr std::size_t position = 3;
  if (cells.size() < position) return false;
  return all_numbers(cells) || !file.options.columns.empty() ||
         names_a_position(std::vector<std::string>(cells.begin(), cells.end())) ||
         comment_names_a_position(file);
}

/// True when every row has a whole number in this column.
bool column_is_whole(const PackingFile& file, std::size_t column) {
  DelimitedTable rows(file.path, file.content, sphere_header_rule());
  while (rows.next())
    if (!parse_whole_number(rows.cells()[column])) return false;
  return true;
}

/// What four or five columns without names can only mean.
std::vector<std::string> customary_names(const PackingFile& file, const DelimitedTable& table) {
  if (const auto& comment = table.likely_header(); comment.line > 0)
    throw InputError(fmt::format(
        "{}:{}: the comment {} names the columns, and none of them radius or diameter; call that column so, "
        "or declare them, as in [packing] columns = [\"id\", \"x\", \"y\", \"z\", \"diameter\"]",
        file.path, comment.line, in_quotes(comment.text)));
  if (table.width() == 4) return {"x", "y", "z", file.path.ends_with(".xyzd") ? "diameter" : "radius"};
  if (table.width() == 5 && column_is_whole(file, 0) && !column_is_whole(file, 4))
    return {"id", "x", "y", "z", "radius"};
  throw InputError(
      fmt::format("{}: rows of {} columns without a header; without names only x y z radius and id x y z "
                  "radius are understood: write a header, or declare the columns, as in [packing] columns = "
                  "[\"x\", \"y\", \"z\", \"radius\", \"material\"]",
                  table.where(), table.width()));
}

/// Watches a column of time: rows of several time steps would lie on top of each other as one packing.
class OneTimeStep {
 public:
  explicit OneTimeStep(const std::vector<std::string>& names) : names_(names) {
    for (std::size_t k = 0; k < names.size(); ++k)
      if (names_a_time(names[k])) columns_.push_back(k);
  }
  void look_at(const DelimitedTable& table) {
    if (columns_.empty()) return;
    for (const std::size_t k : columns_) require_same(table, k);
    first_line_ = first_line_ == 0 ? table.line() : first_line_;
  }

 private:
  void require_same(const DelimitedTable& table, std::size_t column) {
    const auto value = parse_number(table.cells()[column]);
    if (!value) return;
    const auto [entry, is_first] = first_.try_emplace(column, *value);
    if (is_first || entry->second == *value) return;
    throw InputError(fmt::format(
        "{}: column '{}' is {}, and {} on line {}: the table holds several time steps, which would "
        "lie on top of each other; export one of them, or rename the column if it is none of time "
        "steps",
        table.where(), names_[column], *value, entry->second, first_line_));
  }

  const std::vector<std::string>& names_;
  std::vector<std::size_t> columns_;
  std::map<std::size_t, double> first_;
  std::size_t first_line_ = 0;
};

Packing read(const PackingFile& file) {
  DelimitedTable table(file.path, file.content, sphere_header_rule());
  SphereLayout layout{.names = table.names(),
                      .place = fmt::format("{}:{}", file.path, table.first_line()),
                      .header = fmt::format("the header '{}'", table.first_text().substr(0, 120)),
                      .cell = stated_cell(file),
                      .cell_binds = true};
  const auto& declared = file.options.columns;
  const bool customary = layout.names.empty() && declared.empty();
  if (!declared.empty()) {
    layout.names = declared;
    layout.header = "the declared columns";
    if (declared.size() != table.width())
      throw InputError(fmt::format("{}: row has {} columns, and {} are declared: {}; declare every column",
                                   table.where(), table.width(), declared.size(), fmt::join(declared, ", ")));
    require_same_meaning(file, table.names());
  } else if (customary) {
    layout.names = customary_names(file, table);
  }
  OneTimeStep time(declared.empty() ? table.names() : declared);
  const std::vector<std::string> names = layout.names;
  SphereRows rows(file, std::move(layout));
  while (table.next()) {
    time.look_at(table);
    rows.add(table.cells(), table.line());
  }
  Packing packing = rows.finish();
  if (customary)
    packing.notes.insert(packing.notes.begin(),
                         fmt::format("no header: the columns are taken as {}", fmt::join(names, ", ")));
  return packing;
}

}  // namespace

PackingFormat table_format() {
  return {"table (CSV, or blanks between the cells)", recognises, read};
}

}  // namespace superstep
