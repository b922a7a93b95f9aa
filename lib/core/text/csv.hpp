#pragma once
/// Tables with known columns: whole-token numbers, errors that name file, line and column.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text/delimited.hpp"

namespace superstep {

/// The text of a table that is in memory, and the file that it is of, for errors.
struct TableText {
  std::string path, content;
};

class CsvReader {
 public:
  /// Reads `path` and its header (see DelimitedTable), in which upper and lower case are the same. Every
  /// required column must stand in it, in any order; optional ones may; anything else is an error that names
  /// the nearest valid column. Rows without a header hold the required columns, in their order. A unit in
  /// brackets behind a name must be one that numbers are taken in anyway, except for columns `with_units`.
  /// Throws InputError.
  CsvReader(std::string path, const std::vector<std::string>& required,
            const std::vector<std::string>& optional = {}, const std::vector<std::string>& with_units = {})
      : CsvReader(text_of(std::move(path)), required, optional, with_units) {}
  /// The same of text that is here.
  explicit CsvReader(TableText text, const std::vector<std::string>& required,
                     const std::vector<std::string>& optional = {},
                     const std::vector<std::string>& with_units = {});
  CsvReader(const CsvReader&) = delete;
  CsvReader& operator=(const CsvReader&) = delete;

  /// Moves to the next row that is not blank; false at the end. A short or long row throws InputError.
  bool next();
  /// Columns are numbered as given: required ones first, then optional ones.
  [[nodiscard]] bool has(std::size_t column) const noexcept { return position_[column] >= 0; }
  [[nodiscard]] std::string_view text(std::size_t column) const noexcept;
  /// That stands in brackets behind its name; empty for none.
  [[nodiscard]] std::string_view unit(std::size_t column) const noexcept;
  [[nodiscard]] double number(std::size_t column) const;
  /// May be written with a fraction of zero, as 3.0 or 3e0.
  [[nodiscard]] std::int64_t integer(std::size_t column) const;
  [[nodiscard]] std::size_t line() const noexcept { return table_->line(); }
  /// "file:line", to begin an error message with.
  [[nodiscard]] std::string where() const;
  [[nodiscard]] std::string where_header() const { return table_->where_header(); }
  /// Of the whole file.
  [[nodiscard]] std::string_view content() const noexcept { return content_; }

 private:
  static TableText text_of(std::string path);
  void place_columns(std::size_t required, const std::vector<std::string>& with_units);
  [[nodiscard]] std::string names() const;

  std::string path_, content_;
  std::optional<DelimitedTable> table_;
  std::vector<std::string> columns_;
  std::vector<std::ptrdiff_t> position_;
};

}  // namespace superstep
