#pragma once
/// Whole text files in memory, read line by line without copying.

#include <cstddef>
#include <string>
#include <string_view>

namespace superstep {

/// Reads a whole text file. Drops a UTF-8 byte order mark.
/// Throws InputError for a missing or unreadable file, a directory, an empty file, and binary content (NUL
/// bytes).
[[nodiscard]] std::string read_text_file(const std::string& path);

/// Walks the lines of a text, LF or CRLF, counting from 1.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}
  /// Moves to the next line; false at the end.
  bool next() noexcept;
  [[nodiscard]] std::string_view line() const noexcept { return line_; }
  [[nodiscard]] std::size_t number() const noexcept { return number_; }

 private:
  std::string_view rest_, line_;
  std::size_t number_ = 0;
};

/// Text without leading and trailing blanks and tabs.
[[nodiscard]] std::string_view trimmed(std::string_view text) noexcept;

/// A value as an error message quotes it: control characters escaped, long ones cut.
[[nodiscard]] std::string quoted(std::string_view value);

}  // namespace superstep
