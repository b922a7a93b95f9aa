#include "packing/formats/text_row.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/error.hpp"
#include "core/text/number.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/recognise.hpp"

namespace superstep {

TextRow::TextRow(std::string path) : path_(std::move(path)) {}

void TextRow::split(std::string_view line, std::size_t number) {
  number_ = number;
  cells_.clear();
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  for (std::size_t k = 0; k < line.size();) {
    while (k < line.size() && is_blank(line[k])) ++k;
    const std::size_t begin = k;
    while (k < line.size() && !is_blank(line[k])) ++k;
    if (k > begin) cells_.push_back(line.substr(begin, k - begin));
  }
}

std::string TextRow::where() const {
  return fmt::format("{}:{}", path_, number_);
}

bool all_numbers(const TextRow& row) {
  for (std::size_t k = 0; k < row.size(); ++k)
    if (!parse_number(row[k])) return false;
  return true;
}

double TextRow::number(std::size_t k, std::string_view name) const {
  const auto value = parse_number(cells_[k]);
  if (!value)
    throw InputError(fmt::format("{}: column '{}' is {}; it must be a finite decimal number such as 1.5e-3",
                                 where(), name, in_quotes(cells_[k])));
  return *value;
}

std::int64_t TextRow::integer(std::size_t k, std::string_view name) const {
  const auto value = parse_whole_number(cells_[k]);
  if (!value)
    throw InputError(
        fmt::format("{}: column '{}' is {}; it must be an integer", where(), name, in_quotes(cells_[k])));
  return *value;
}

void TextRow::require_size(std::size_t size, std::string_view layout) const {
  if (cells_.size() != size)
    throw InputError(
        fmt::format("{}: row has {} columns; it must have {}: {}", where(), cells_.size(), size, layout));
}

}  // namespace superstep
