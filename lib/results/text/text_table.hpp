#pragma once
/// Aligned tables for the terminal.

#include <string>
#include <vector>

namespace superstep {

/// Colours of a terminal, or none.
enum class Style { plain, bold, dim, red, yellow, green };

/// `text` in a style; unchanged when `color` is false.
[[nodiscard]] std::string styled(const std::string& text, Style style, bool color);

/// Columns as wide as their widest cell, two blanks apart.
class TextTable {
 public:
  enum class Align { left, right };
  struct Header {
    std::string group;  ///< heading shared with the neighbours that have the same one; may be empty
    std::string title;
    Align align = Align::right;
  };
  struct Cell {
    std::string text;
    Style style = Style::plain;
  };

  explicit TextTable(std::vector<Header> headers) : headers_(std::move(headers)) {}
  /// One cell per header.
  void add_row(std::vector<Cell> cells) { rows_.push_back(std::move(cells)); }
  [[nodiscard]] std::string text(bool color) const;

 private:
  /// Neighbouring columns under one heading: the column after the last one, and the width of all together.
  struct Group {
    std::size_t next, width;
  };
  [[nodiscard]] std::vector<std::size_t> widths() const;
  void make_room_for_groups(std::vector<std::size_t>& widths) const;
  [[nodiscard]] Group group_at(std::size_t first, const std::vector<std::size_t>& widths) const;
  [[nodiscard]] std::string group_line(const std::vector<std::size_t>& widths) const;

  std::vector<Header> headers_;
  std::vector<std::vector<Cell>> rows_;
};

}  // namespace superstep
