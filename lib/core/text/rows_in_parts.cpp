#include "core/text/rows_in_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "core/error.hpp"
#include "core/text/decoding/encoding.hpp"
#include "core/text/delimited.hpp"
#include "core/text/text_file.hpp"

namespace superstep {
namespace {

/// Comments, header and first row together are shorter than that.
constexpr std::uint64_t longest_head = std::uint64_t{1} << 20;

/// Bytes [first, last) of a file.
std::string bytes_of(const std::string& path, std::uint64_t first, std::uint64_t last) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes(last - first, '\0');
  if (!file.seekg(static_cast<std::streamoff>(first)) ||
      !file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    throw InputError(
        fmt::format("{}: bytes {} to {} cannot be read; was the file changed meanwhile?", path, first, last));
  return bytes;
}

/// Up to the end of the last line that is whole, or of the file.
std::string first_lines(const std::string& path, std::uint64_t size) {
  std::string text = bytes_of(path, 0, std::min(size, longest_head));
  if (text.size() < size) text.resize(text.rfind('\n') + 1);  // 0: one line that is longer than any head
  return text;
}

std::size_t begin_of_line(std::string_view text, std::size_t line) {
  std::size_t begin = 0;
  for (std::size_t k = 1; k < line; ++k) begin = text.find('\n', begin) + 1;
  return begin;
}

bool holds_more_than_comments(std::string_view text) {
  LineReader lines(text);
  while (lines.next())
    if (!is_comment_or_blank(lines.line())) return true;
  return false;
}

}  // namespace

std::optional<RowsInParts> RowsInParts::open(const std::string& path, std::string& why_not) {
  require_regular_file(path);
  RowsInParts rows;
  rows.path_ = path;
  rows.end_ = std::filesystem::file_size(path);
  rows.head_ = first_lines(path, rows.end_);
  const std::string& text = rows.head_;
  if (text.find('\0') != std::string::npos || to_utf8(text) != text || text.starts_with("\x1f\x8b")) {
    why_not = "it is packed or binary, or begins with a mark of its encoding";
    return std::nullopt;
  }
  return rows;
}

void RowsInParts::begin_rows_at(std::size_t line) {
  begin_ = begin_of_line(head_, line);
  head_.resize(begin_);
}

bool RowsInParts::has_header_line() const {
  return holds_more_than_comments(head_);
}

std::string RowsInParts::read(std::uint64_t first, std::uint64_t last) const {
  first = std::min(begin_ + first, end_);
  last = std::min(begin_ + last, end_);
  if (first == last) return {};
  // A row is whose it begins: that before the first one ends here, and the last one may end among others'
  // bytes.
  const std::uint64_t before = first > begin_ ? 1 : 0;
  std::string text = bytes_of(path_, first - before, last);
  constexpr std::uint64_t step = 4096;
  for (std::uint64_t end = last; end < end_ && text.back() != '\n';) {
    const std::string more = bytes_of(path_, end, std::min(end + step, end_));
    const auto line_end = more.find('\n');
    text += more.substr(0, line_end == more.npos ? more.size() : line_end + 1);
    end += more.size();
  }
  if (before > 0) text.erase(0, std::min(text.find('\n'), text.size() - 1) + 1);
  if (!holds_more_than_comments(text)) return {};
  text.insert(0, head_);
  return text;
}

}  // namespace superstep
