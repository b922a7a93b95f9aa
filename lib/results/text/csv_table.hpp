#pragma once
/// CSV files that we wrote ourselves, read back: quoted cells, named columns (RFC 4180).

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace superstep {

class CsvTable {
 public:
  /// Reads a whole file. Throws InputError when it cannot be read, a quote stays open, or a row has another
  /// number of cells than the header.
  explicit CsvTable(const std::string& path);
  CsvTable(const CsvTable&) = delete;
  CsvTable& operator=(const CsvTable&) = delete;

  [[nodiscard]] const std::vector<std::string>& columns() const noexcept { return columns_; }
  [[nodiscard]] std::size_t rows() const noexcept {
    return columns_.empty() ? 0 : cells_.size() / columns_.size();
  }
  /// Position of a column; InputError when there is none of that name.
  [[nodiscard]] std::size_t column(std::string_view name) const;
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const noexcept;
  /// Text of a cell as it was before it was written.
  [[nodiscard]] std::string text(std::size_t row, std::size_t column) const;
  /// Number in a cell, empty for an empty cell; InputError for anything else.
  [[nodiscard]] std::optional<double> number(std::size_t row, std::size_t column) const;
  /// The same, but an empty cell is an InputError.
  [[nodiscard]] double required(std::size_t row, std::size_t column) const;
  /// Whole number in a cell; InputError for anything else.
  [[nodiscard]] std::int64_t whole(std::size_t row, std::size_t column) const;
  /// The same of one that counts something; empty for an empty cell.
  [[nodiscard]] std::optional<std::uint64_t> count(std::size_t row, std::size_t column) const;
  /// Throws InputError about a row: "file: row n below the header: rule".
  [[noreturn]] void reject(std::size_t row, const std::string& rule) const;

 private:
  void parse();
  void take_column(std::string name);
  std::string_view take_cell(std::size_t& position, bool& ends_row);
  std::string_view take_quoted(std::size_t& position);

  std::string path_, content_;
  std::deque<std::string> unquoted_;  // cells that are not a piece of the content
  std::vector<std::string> columns_;
  std::vector<std::string_view> cells_;
};

}  // namespace superstep
