#pragma once
/// Strict CSV with a header line: named columns, whole-token numbers, errors that name file, line and column.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/text_file.hpp"

namespace superstep {

class CsvReader {
 public:
  /// Reads `path` and its header, before which comments may stand (`# ...`). Every required column must stand
  /// in the header, in any order; optional ones may; anything else is an error that names the nearest valid
  /// column. Throws InputError.
  CsvReader(std::string path, std::vector<std::string> required, std::vector<std::string> optional = {});
  CsvReader(const CsvReader&) = delete;
  CsvReader& operator=(const CsvReader&) = delete;

  /// Moves to the next row that is not blank; false at the end. A short or long row throws InputError.
  bool next();
  /// Columns are numbered as given: required ones first, then optional ones.
  [[nodiscard]] bool has(std::size_t column) const noexcept { return position_[column] >= 0; }
  [[nodiscard]] std::string_view text(std::size_t column) const noexcept;
  [[nodiscard]] double number(std::size_t column) const;
  [[nodiscard]] std::int64_t integer(std::size_t column) const;
  [[nodiscard]] std::size_t line() const noexcept { return lines_.number(); }
  /// "file:line", to begin an error message with.
  [[nodiscard]] std::string where() const;

 private:
  void split(std::string_view line);
  [[nodiscard]] std::string names() const;

  std::string path_, content_;
  LineReader lines_{""};
  std::vector<std::string> columns_;
  std::vector<std::ptrdiff_t> position_;
  std::vector<std::string_view> cells_;
  std::size_t width_ = 0;
};

}  // namespace superstep
