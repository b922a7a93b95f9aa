#include "results/text/plain_table.hpp"

#include <algorithm>

#include "results/text/text_table.hpp"

namespace superstep {
namespace {

constexpr std::size_t line_width = 110, longest_cell = 70;

Style style_of(const std::string& kind) {
  if (kind == "strong") return Style::bold;
  if (kind == "dim") return Style::dim;
  if (kind == "bad") return Style::red;
  return kind == "good" ? Style::green : Style::plain;
}

/// Broken between words into lines that a terminal shows whole.
std::string wrapped(const std::string& text) {
  std::string out;
  std::size_t column = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size()), length = end - begin;
    if (column > 0 && column + 1 + length > line_width) {
      out += '\n';
      column = 0;
    } else if (column > 0) {
      out += ' ';
      ++column;
    }
    out.append(text, begin, length);
    column += length;
    begin = end + 1;
  }
  return out;
}

std::string shortened(const std::string& text) {
  return text.size() <= longest_cell ? text : text.substr(0, longest_cell - 3) + "...";
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("|*_`[]\\#<>").find(c) != std::string_view::npos) out += '\\';
    out += c == '\n' || c == '\t' ? ' ' : c;
  }
  return out;
}

}  // namespace

std::string terminal_text(const PlainTable& table, bool color) {
  std::vector<TextTable::Header> headers;
  for (std::size_t k = 0; k < table.headers.size(); ++k)
    headers.push_back({"", table.headers[k], TextTable::Align::left});
  TextTable out(headers);
  for (const auto& row : table.rows) {
    std::vector<TextTable::Cell> cells;
    for (const auto& cell : row) cells.push_back({shortened(cell.text), style_of(cell.kind)});
    out.add_row(std::move(cells));
  }
  return styled(table.title, Style::bold, color) + "\n" + wrapped(table.intro) + "\n\n" + out.text(color);
}

std::string markdown_text(const PlainTable& table) {
  std::string out = "### " + escaped(table.title) + "\n\n" + escaped(table.intro) + "\n\n|", rule = "|";
  for (const auto& header : table.headers) {
    out += " " + escaped(header) + " |";
    rule += "---|";
  }
  out += "\n" + rule + "\n";
  for (const auto& row : table.rows) {
    out += "|";
    for (const auto& cell : row)
      out += cell.kind == "strong" ? " **" + escaped(cell.text) + "** |" : " " + escaped(cell.text) + " |";
    out += "\n";
  }
  return out;
}

}  // namespace superstep
