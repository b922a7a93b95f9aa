#include "results/text/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace superstep {
namespace {

constexpr std::size_t gap = 2;

std::string without_trailing_blanks(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string aligned(const std::string& text, TextTable::Align align, std::size_t width) {
  return align == TextTable::Align::left ? fmt::format("{:<{}}", text, width)
                                         : fmt::format("{:>{}}", text, width);
}

}  // namespace

std::string styled(const std::string& text, Style style, bool color) {
  if (!color || style == Style::plain) return text;
  const char* code = "";
  switch (style) {
    case Style::bold:
      code = "1";
      break;
    case Style::dim:
      code = "2";
      break;
    case Style::red:
      code = "31";
      break;
    case Style::yellow:
      code = "33";
      break;
    case Style::green:
      code = "32";
      break;
    case Style::plain:
      break;
  }
  return fmt::format("\033[{}m{}\033[0m", code, text);
}

std::vector<std::size_t> TextTable::widths() const {
  std::vector<std::size_t> widths;
  for (const auto& header : headers_) widths.push_back(header.title.size());
  for (const auto& row : rows_)
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].text.size());
  make_room_for_groups(widths);
  return widths;
}

// The last column of a group takes what the group's heading needs beyond its columns.
void TextTable::make_room_for_groups(std::vector<std::size_t>& widths) const {
  for (std::size_t k = 0; k < headers_.size();) {
    const Group group = group_at(k, widths);
    const std::size_t needed =
        headers_[k].group.size() + (headers_[k].group.empty() ? 0 : 2);  // a blank either side
    if (needed > group.width) widths[group.next - 1] += needed - group.width;
    k = group.next;
  }
}

TextTable::Group TextTable::group_at(std::size_t first, const std::vector<std::size_t>& widths) const {
  Group group{.next = first + 1, .width = widths[first]};
  const std::string& name = headers_[first].group;
  for (; !name.empty() && group.next < headers_.size() && headers_[group.next].group == name; ++group.next)
    group.width += gap + widths[group.next];
  return group;
}

std::string TextTable::group_line(const std::vector<std::size_t>& widths) const {
  std::string line;
  for (std::size_t k = 0; k < headers_.size();) {
    const Group group = group_at(k, widths);
    const std::string& name = headers_[k].group;
    line +=
        name.empty() ? std::string(group.width, ' ') : fmt::format("{:-^{}}", " " + name + " ", group.width);
    line += std::string(gap, ' ');
    k = group.next;
  }
  return without_trailing_blanks(line);
}

std::string TextTable::text(bool color) const {
  const auto width = widths();
  std::string out;
  const bool grouped = std::any_of(headers_.begin(), headers_.end(),
                                   [](const Header& header) { return !header.group.empty(); });
  if (grouped) out += styled(group_line(width), Style::dim, color);
  std::string line;
  for (std::size_t k = 0; k < headers_.size(); ++k)
    line += aligned(headers_[k].title, headers_[k].align, width[k]) + std::string(gap, ' ');
  out += styled(without_trailing_blanks(line), Style::bold, color);
  for (const auto& row : rows_) {
    line.clear();
    for (std::size_t k = 0; k < row.size(); ++k)
      line += styled(aligned(row[k].text, headers_[k].align, width[k]), row[k].style, color) +
              std::string(gap, ' ');
    out += without_trailing_blanks(line);
  }
  return out;
}

}  // namespace superstep
