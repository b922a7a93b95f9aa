#include "core/text/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/text/number.hpp"
#include "core/text/suggest.hpp"

namespace superstep {

CsvReader::CsvReader(std::string path, std::vector<std::string> required, std::vector<std::string> optional)
    : path_(std::move(path)), content_(read_text_file(path_)), columns_(required) {
  columns_.insert(columns_.end(), optional.begin(), optional.end());
  position_.assign(columns_.size(), -1);
  lines_ = LineReader(content_);
  while (lines_.next() && (trimmed(lines_.line()).empty() || trimmed(lines_.line()).front() == '#')) {
  }
  split(lines_.line());
  width_ = cells_.size();
  for (std::size_t k = 0; k < width_; ++k) {
    const auto column = std::find(columns_.begin(), columns_.end(), cells_[k]);
    if (column == columns_.end())
      throw InputError(fmt::format("{}: unknown column {} in the header{}", where(), quoted(cells_[k]),
                                   suggestion(cells_[k], columns_)));
    auto& position = position_[static_cast<std::size_t>(column - columns_.begin())];
    if (position >= 0)
      throw InputError(fmt::format("{}: column '{}' stands twice in the header; keep one", where(), *column));
    position = static_cast<std::ptrdiff_t>(k);
  }
  for (std::size_t column = 0; column < required.size(); ++column)
    if (!has(column))
      throw InputError(fmt::format("{}: column '{}' is missing from the header '{}'; expected {}", where(),
                                   required[column], lines_.line().substr(0, 120), names()));
}

std::string CsvReader::names() const {
  return fmt::format("{}", fmt::join(columns_, ","));
}

std::string CsvReader::where() const {
  return fmt::format("{}:{}", path_, lines_.number());
}

void CsvReader::split(std::string_view line) {
  cells_.clear();
  for (;;) {
    const std::size_t comma = line.find(',');
    cells_.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return;
    line.remove_prefix(comma + 1);
  }
}

bool CsvReader::next() {
  while (lines_.next()) {
    if (trimmed(lines_.line()).empty()) continue;
    split(lines_.line());
    if (cells_.size() != width_)
      throw InputError(
          fmt::format("{}: row '{}' has {} cells, the header has {}; every row needs all columns, and "
                      "numbers a decimal point, "
                      "not a comma",
                      where(), lines_.line().substr(0, 120), cells_.size(), width_));
    return true;
  }
  return false;
}

std::string_view CsvReader::text(std::size_t column) const noexcept {
  const auto position = position_[column];
  return position < 0 ? std::string_view{} : cells_[static_cast<std::size_t>(position)];
}

double CsvReader::number(std::size_t column) const {
  const auto value = parse_number(text(column));
  if (!value)
    throw InputError(fmt::format("{}: column '{}' is {}; it must be a finite decimal number such as 1.5e-3",
                                 where(), columns_[column], quoted(text(column))));
  return *value;
}

std::int64_t CsvReader::integer(std::size_t column) const {
  const auto value = parse_integer(text(column));
  if (!value)
    throw InputError(fmt::format("{}: column '{}' is {}; it must be an integer", where(), columns_[column],
                                 quoted(text(column))));
  return *value;
}

}  // namespace superstep
