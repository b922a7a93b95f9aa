#pragma once
/// One line of a table whose columns are separated by blanks.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace superstep {

/// Reused line after line: the memory for the columns is allocated once.
class TextRow {
 public:
  explicit TextRow(std::string path);

  /// Splits a line; `number` counts from 1. The text must outlive the row's use.
  void split(std::string_view line, std::size_t number);

  [[nodiscard]] std::size_t size() const noexcept { return cells_.size(); }
  [[nodiscard]] std::size_t line() const noexcept { return number_; }
  [[nodiscard]] std::string_view operator[](std::size_t k) const noexcept { return cells_[k]; }
  [[nodiscard]] const std::vector<std::string_view>& cells() const noexcept { return cells_; }
  /// Column k < size() as a number; errors call it `name`. Throws InputError.
  [[nodiscard]] double number(std::size_t k, std::string_view name) const;
  [[nodiscard]] std::int64_t integer(std::size_t k, std::string_view name) const;
  /// Throws InputError unless the row has so many columns; `layout` says which.
  void require_size(std::size_t size, std::string_view layout) const;
  /// "file:line", to begin an error message with.
  [[nodiscard]] std::string where() const;

 private:
  std::string path_;
  std::vector<std::string_view> cells_;
  std::size_t number_ = 0;
};

}  // namespace superstep
