#pragma once
/// Tables that are read in parts: a head that everybody knows, and rows, of which each reads those that begin
/// among its bytes.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace superstep {

class RowsInParts {
 public:
  /// Opens plain text that is not packed. Nothing where the file is another one; `why_not` says then what it
  /// is. Throws InputError for a file that cannot be read.
  [[nodiscard]] static std::optional<RowsInParts> open(const std::string& path, std::string& why_not);

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  /// Lines from the beginning of the file, more than any head has; once it is known where rows begin, the
  /// head alone.
  [[nodiscard]] const std::string& head() const noexcept { return head_; }
  /// Ends the head before a line of it.
  void begin_rows_at(std::size_t line);
  /// True where the head holds more than comments.
  [[nodiscard]] bool has_header_line() const;
  /// Bytes of all rows.
  [[nodiscard]] std::uint64_t bytes() const noexcept { return end_ - begin_; }

  /// The head and the rows that begin at bytes [first, last) of all; empty where none begins there. Throws
  /// InputError.
  [[nodiscard]] std::string read(std::uint64_t first, std::uint64_t last) const;

 private:
  std::string path_, head_;
  std::uint64_t begin_ = 0, end_ = 0;  // of the rows in the file
};

}  // namespace superstep
