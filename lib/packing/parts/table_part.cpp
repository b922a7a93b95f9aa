#include "packing/parts/table_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "core/text/decoding/encoding.hpp"
#include "core/text/delimited.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/columns/columns.hpp"
#include "packing/formats/columns/known_names.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/stated.hpp"

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

bool holds_a_row(std::string_view text) {
  LineReader lines(text);
  while (lines.next())
    if (!is_comment_or_blank(lines.line())) return true;
  return false;
}

}  // namespace

std::optional<TableInParts> TableInParts::open(const std::string& path, const PackingOptions& options,
                                               std::string& why_not) {
  const auto is_other = [&](const char* what) {
    why_not = what;
    return std::nullopt;
  };
  require_regular_file(path);
  const std::uint64_t size = std::filesystem::file_size(path);
  const std::string text = first_lines(path, size);
  if (text.find('\0') != std::string::npos || to_utf8(text) != text || text.starts_with("\x1f\x8b"))
    return is_other("it is packed or binary, or begins with a mark of its encoding");
  if (!is_table(path, text, options)) return is_other("it is no table such as CSV");
  const PackingFile file{
      .path = path, .content = text, .options = options, .stated = stated_length_unit(path, text)};
  if (stated_cell(file) || options.box) return is_other("it has a box");
  DelimitedTable table(path, text, sphere_header_rule());
  if (table.names().empty() && options.columns.empty()) return is_other("its columns have no names");
  if (!table.next()) return is_other("it has no rows");
  const auto& names = options.columns.empty() ? table.names() : options.columns;
  const SphereColumns columns = find_sphere_columns(names, {}, path, "the header");
  if (columns.material != SphereColumns::none) return is_other("it has a column of materials");
  if (std::any_of(names.begin(), names.end(), names_a_time)) return is_other("it has a column of time");
  TableInParts parts;
  parts.path_ = path;
  parts.options_ = options;
  parts.begin_ = begin_of_line(text, table.line());
  parts.end_ = size;
  parts.head_ = text.substr(0, parts.begin_);
  parts.has_ids_ = columns.id != SphereColumns::none;
  // The first row alone says what the rest says of units.
  const std::size_t row_end = std::min(text.find('\n', parts.begin_), text.size());
  parts.length_unit_ = read_table(path, text.substr(0, row_end), options).length_unit;
  return parts;
}

Packing TableInParts::read(std::uint64_t first, std::uint64_t last) const {
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
  if (!holds_a_row(text)) return {};
  text.insert(0, head_);
  Packing packing = read_table(path_, text, options_);
  packing.attributes.clear();
  packing.text_columns.clear();
  return packing;
}

}  // namespace superstep
