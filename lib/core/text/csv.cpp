#include "core/text/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/text/bracketed_unit.hpp"
#include "core/text/number.hpp"
#include "core/text/suggest.hpp"

namespace superstep {

TableText CsvReader::text_of(std::string path) {
  std::string content = read_text_file(path);
  return {std::move(path), std::move(content)};
}

CsvReader::CsvReader(TableText text, const std::vector<std::string>& required,
                     const std::vector<std::string>& optional, const std::vector<std::string>& with_units)
    : path_(std::move(text.path)), content_(std::move(text.content)), columns_(required) {
  columns_.insert(columns_.end(), optional.begin(), optional.end());
  position_.assign(columns_.size(), -1);
  const std::size_t half = (required.size() + 1) / 2;  // one may be misspelled
  table_.emplace(path_, content_, header_of(columns_, half));
  place_columns(required.size(), with_units);
}

void CsvReader::place_columns(std::size_t required, const std::vector<std::string>& with_units) {
  const auto& header = table_->names();
  for (std::size_t k = 0; k < header.size(); ++k) {
    const std::string name = bare_name(header[k]);
    if (name.empty()) continue;  // row numbers, or what a delimiter at the end of the header makes
    const auto column = std::find(columns_.begin(), columns_.end(), name);
    if (column == columns_.end())
      throw InputError(fmt::format("{}: unknown column {} in the header{}", where_header(),
                                   in_quotes(header[k]), suggestion(header[k], columns_)));
    const bool reads_units = std::find(with_units.begin(), with_units.end(), *column) != with_units.end();
    if (!reads_units) require_plain_unit(header[k], where_header());
    auto& position = position_[static_cast<std::size_t>(column - columns_.begin())];
    if (position >= 0)
      throw InputError(
          fmt::format("{}: column '{}' stands twice in the header; keep one", where_header(), *column));
    position = static_cast<std::ptrdiff_t>(k);
  }
  if (header.empty() && table_->width() == required)
    for (std::size_t column = 0; column < required; ++column)
      position_[column] = static_cast<std::ptrdiff_t>(column);
  for (std::size_t column = 0; column < required; ++column)
    if (!has(column))
      throw InputError(fmt::format("{}: column '{}' is missing from the header '{}'; expected {}",
                                   where_header(), columns_[column], table_->first_text().substr(0, 120),
                                   names()));
}

std::string CsvReader::names() const {
  return fmt::format("{}", fmt::join(columns_, ","));
}

std::string CsvReader::where() const {
  return table_->where();
}

bool CsvReader::next() {
  return table_->next();
}

std::string_view CsvReader::text(std::size_t column) const noexcept {
  const auto position = position_[column];
  return position < 0 ? std::string_view{} : table_->cells()[static_cast<std::size_t>(position)];
}

std::string_view CsvReader::unit(std::size_t column) const noexcept {
  const auto position = position_[column];
  if (position < 0 || table_->names().empty()) return {};
  return split_bracketed_unit(table_->names()[static_cast<std::size_t>(position)]).unit;
}

double CsvReader::number(std::size_t column) const {
  const auto value = parse_number(text(column));
  if (!value)
    throw InputError(fmt::format("{}: column '{}' is {}; it must be a finite decimal number such as 1.5e-3",
                                 where(), columns_[column], in_quotes(text(column))));
  return *value;
}

std::int64_t CsvReader::integer(std::size_t column) const {
  const auto value = parse_whole_number(text(column));
  if (!value)
    throw InputError(fmt::format("{}: column '{}' is {}; it must be an integer", where(), columns_[column],
                                 in_quotes(text(column))));
  return *value;
}

}  // namespace superstep
