#pragma once
/// Tables as people have them: cells between commas, semicolons, tabs or blanks, quoted or not, with
/// comments, with a header or without.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/text_file.hpp"

namespace superstep {

/// Splits a line at a delimiter; ' ' stands for runs of blanks and tabs. Cells lose the blanks around them
/// and their double quotes. Returns false for a quote that is never closed.
bool split_cells(std::string_view line, char delimiter, std::vector<std::string_view>& cells);

/// The delimiter of a table by one of its lines: ';' before tab before ',' (outside quotes), else blanks.
[[nodiscard]] char delimiter_of(std::string_view line) noexcept;

/// The delimiter that spreadsheets state in a line of its own, as in "sep=;"; NUL in other lines.
[[nodiscard]] char stated_delimiter(std::string_view line) noexcept;

/// True for a line that says nothing to a table: blank, or a comment (`#` or `%`). What spreadsheets put into
/// a cell that they cannot compute begins none ("#N/A,1,2").
[[nodiscard]] bool is_comment_or_blank(std::string_view line) noexcept;

/// Lower case of ASCII letters.
[[nodiscard]] std::string lower_case(std::string_view text);

/// How a reader tells headers that stand in comments. Without it any line of words is one that has as many as
/// there are columns.
struct HeaderRule {
  std::function<bool(std::string_view)> is_column;                       ///< the name of one that it knows
  std::function<bool(const std::vector<std::string>& names)> is_header;  ///< of as many as there are columns
};

/// The rule of a table with these columns, in lower case: a header names `least` of them, or all that it has.
[[nodiscard]] HeaderRule header_of(std::vector<std::string> columns, std::size_t least);

class DelimitedTable {
 public:
  struct Comment {
    std::string_view text;
    std::size_t line = 0;
  };

  /// Finds delimiter and header of `text`, which must outlive the table. The header is the first line that is
  /// no comment, where it holds a word and no number; else the last comment before it that has as many names
  /// and is one by the rule, or says units in brackets; else there is none. Signs around the names do not
  /// matter ("## x, y", "# columns: x | y"). A comment that begins with names and goes on otherwise may hold
  /// units, and throws InputError.
  DelimitedTable(std::string path, std::string_view text, const HeaderRule& rule = {});

  /// Names of the columns as they are written; empty without a header.
  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }
  /// Cells of every row.
  [[nodiscard]] std::size_t width() const noexcept { return width_; }
  [[nodiscard]] char delimiter() const noexcept { return delimiter_; }
  /// Line of the header, or of the first row.
  [[nodiscard]] std::size_t first_line() const noexcept { return first_line_; }
  [[nodiscard]] std::string_view first_text() const noexcept { return first_text_; }

  /// A comment above the rows that has a name for each column, half of them known at least, and is no header
  /// by the rule; line 0 = there is none.
  [[nodiscard]] const Comment& likely_header() const noexcept { return likely_header_; }

  /// Moves to the next row that is neither blank nor a comment; false at the end. A short or long row throws
  /// InputError, and so does a header in a comment that stands a second time.
  bool next();
  [[nodiscard]] const std::vector<std::string_view>& cells() const noexcept { return cells_; }
  [[nodiscard]] std::size_t line() const noexcept { return line_; }
  /// "file:line" of the row, to begin an error message with.
  [[nodiscard]] std::string where() const;
  /// The same of the header, or of the first row where there is none.
  [[nodiscard]] std::string where_header() const;

 private:
  void take_header_from(const std::vector<Comment>& comments, const HeaderRule& rule);
  [[nodiscard]] std::vector<std::vector<std::string>> names_of(std::string_view comment) const;
  [[nodiscard]] bool could_be_header(const std::vector<std::string>& names) const;
  [[nodiscard]] bool is_likely_header(const std::vector<std::string>& names, const HeaderRule& rule) const;
  [[nodiscard]] bool is_header(const std::vector<std::string>& names, const HeaderRule& rule) const;
  void reject_half_a_header(const Comment& comment, const HeaderRule& rule) const;
  void reject_second_header(std::string_view comment) const;
  void split(std::string_view line);
  void take_last_delimiter_off(std::string_view line);
  [[nodiscard]] bool ends_with_delimiter(std::string_view line) const;

  std::string path_;
  LineReader lines_;
  std::vector<std::string> names_;
  std::vector<std::string_view> cells_;
  std::string_view first_text_, first_row_;
  Comment likely_header_;
  std::string_view header_comment_;  ///< the whole line, where the header stands in a comment
  std::size_t width_ = 0, line_ = 0, first_line_ = 0;
  char delimiter_ = ',';
  bool row_waits_ = false;  ///< the first row was looked at to find out that there is no header
};

}  // namespace superstep
