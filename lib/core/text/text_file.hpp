#pragma once
/// Whole text files in memory, read line by line without copying.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace superstep {

/// Bytes that a file with data may have: ten times what a table of a hundred million contacts needs.
inline constexpr std::uintmax_t largest_data_file = std::uintmax_t{1} << 35;

/// Throws InputError unless `path` names a regular file of at most `most` bytes: a device has no end, a pipe
/// no beginning for the second look, and either would be waited for in vain.
void require_regular_file(const std::string& path, std::uintmax_t most = largest_data_file);

/// True where `path` names a regular file; a link to one counts.
[[nodiscard]] bool is_regular_file(const std::string& path);

/// Reads a whole file, unpacked where it is gzipped. Throws InputError for a missing or unreadable file, and
/// anything but a regular file of at most `most` bytes, packed or unpacked.
[[nodiscard]] std::string read_bytes(const std::string& path, std::uintmax_t most = largest_data_file);

/// The same of what may be text: as UTF-8 where it is UTF-16, without byte order mark, old line ends as new
/// ones.
[[nodiscard]] std::string read_file(const std::string& path, std::uintmax_t most = largest_data_file);

/// The same of text. Throws InputError for an empty file and for binary content (NUL bytes), too.
[[nodiscard]] std::string read_text_file(const std::string& path, std::uintmax_t most = largest_data_file);

/// Throws InputError for NUL bytes.
void refuse_binary(std::string_view text, const std::string& path);

/// Throws InputError for the text of an empty file, or one of blanks alone.
void require_content(std::string_view text, const std::string& path);

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
[[nodiscard]] std::string in_quotes(std::string_view value);

}  // namespace superstep
