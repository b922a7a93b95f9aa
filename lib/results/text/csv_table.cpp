#include "results/text/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/text/number.hpp"
#include "core/text/suggest.hpp"
#include "core/text/text_file.hpp"
#include "results/text/csv_text.hpp"

namespace superstep {

CsvTable::CsvTable(const std::string& path) : path_(path), content_(read_text_file(path)) {
  parse();
}

void CsvTable::parse() {
  std::size_t position = 0;
  std::vector<std::string_view> row;
  std::size_t rows = 0;
  while (position < content_.size()) {
    row.clear();
    for (bool ends_row = false; !ends_row;) row.push_back(take_cell(position, ends_row));
    if (row.size() == 1 && row.front().empty()) continue;            // a blank line
    if (columns_.empty() && row.front().starts_with('#')) continue;  // what a table states above its header
    if (columns_.empty()) {
      for (const auto& name : row) take_column(csv_text_of(name));
      continue;
    }
    ++rows;
    if (row.size() != columns_.size())
      reject(rows - 1, fmt::format("it has {} cells, the header has {}", row.size(), columns_.size()));
    cells_.insert(cells_.end(), row.begin(), row.end());
  }
}

void CsvTable::take_column(std::string name) {
  if (find(name))
    throw InputError(fmt::format("{}: the header has two columns '{}'; write the file anew", path_, name));
  columns_.push_back(std::move(name));
}

std::string_view CsvTable::take_cell(std::size_t& position, bool& ends_row) {
  const bool quoted = position < content_.size() && content_[position] == '"';
  std::string_view cell;
  if (quoted) cell = take_quoted(position);
  const std::size_t end = std::min(content_.find_first_of(",\n", position), content_.size());
  if (!quoted) cell = std::string_view(content_).substr(position, end - position);
  if (!quoted && cell.ends_with('\r')) cell.remove_suffix(1);
  ends_row = end == content_.size() || content_[end] == '\n';
  position = std::min(end + 1, content_.size());
  if (!ends_row && position == content_.size()) ends_row = true;
  return cell;
}

std::string_view CsvTable::take_quoted(std::size_t& position) {
  std::string text;
  for (std::size_t k = position + 1; k < content_.size(); ++k) {
    if (content_[k] != '"') {
      text += content_[k];
    } else if (k + 1 < content_.size() && content_[k + 1] == '"') {
      text += content_[k++];
    } else {
      position = k + 1;
      return unquoted_.emplace_back(std::move(text));
    }
  }
  reject(rows(), "a quote stays open");
}

void CsvTable::reject(std::size_t row, const std::string& rule) const {
  throw InputError(fmt::format("{}: row {} below the header: {}; write the file anew", path_, row + 1, rule));
}

std::optional<std::size_t> CsvTable::find(std::string_view name) const noexcept {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  if (found == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns_.begin());
}

std::size_t CsvTable::column(std::string_view name) const {
  if (const auto found = find(name)) return *found;
  throw InputError(fmt::format("{}: column '{}' is missing from the header{}; write the file anew", path_,
                               name, suggestion(name, columns_)));
}

std::string CsvTable::text(std::size_t row, std::size_t column) const {
  return csv_text_of(cells_[row * columns_.size() + column]);
}

std::optional<double> CsvTable::number(std::size_t row, std::size_t column) const {
  const auto cell = cells_[row * columns_.size() + column];
  if (cell.empty()) return std::nullopt;
  const auto value = parse_number(cell);
  if (!value)
    reject(row, fmt::format("column '{}' is {}; it must be a finite number or empty", columns_[column],
                            in_quotes(cell)));
  return value;
}

double CsvTable::required(std::size_t row, std::size_t column) const {
  const auto value = number(row, column);
  if (!value) reject(row, fmt::format("column '{}' is empty", columns_[column]));
  return *value;
}

std::int64_t CsvTable::whole(std::size_t row, std::size_t column) const {
  const auto cell = cells_[row * columns_.size() + column];
  const auto value = parse_whole_number(cell);
  if (!value)
    reject(row,
           fmt::format("column '{}' is {}; it must be a whole number", columns_[column], in_quotes(cell)));
  return *value;
}

std::optional<std::uint64_t> CsvTable::count(std::size_t row, std::size_t column) const {
  const auto cell = cells_[row * columns_.size() + column];
  if (cell.empty()) return std::nullopt;
  const auto value = parse_whole_number(cell);
  if (!value || *value < 0)
    reject(row, fmt::format("column '{}' is {}; it must be a whole number that is not negative",
                            columns_[column], in_quotes(cell)));
  return static_cast<std::uint64_t>(*value);
}

}  // namespace superstep
