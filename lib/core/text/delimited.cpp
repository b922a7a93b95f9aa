#include "core/text/delimited.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "core/error.hpp"
#include "core/text/bracketed_unit.hpp"
#include "core/text/number.hpp"

namespace superstep {
namespace {

bool is_blank(char c) noexcept {
  return c == ' ' || c == '\t' || c == '\r';
}

/// Takes one cell off the front of `rest`, up to the delimiter, which goes too; `more` tells whether it was
/// there.
bool take_cell(std::string_view& rest, char delimiter, std::string_view& cell, bool& more) {
  std::size_t k = 0;
  while (k < rest.size() && is_blank(rest[k]) && rest[k] != delimiter) ++k;
  std::size_t end = std::string_view::npos;
  if (k < rest.size() && rest[k] == '"') {
    std::size_t close = k + 1;
    for (;; close += 2) {  // a doubled quote stands for one
      close = rest.find('"', close);
      if (close == std::string_view::npos) return false;
      if (close + 1 >= rest.size() || rest[close + 1] != '"') break;
    }
    cell = trimmed(rest.substr(k + 1, close - k - 1));
    end = delimiter == ' ' ? rest.find_first_of(" \t\r", close) : rest.find(delimiter, close);
    if (!trimmed(rest.substr(close + 1, end == std::string_view::npos ? end : end - close - 1)).empty())
      return false;
  } else {
    end = delimiter == ' ' ? rest.find_first_of(" \t\r", k) : rest.find(delimiter, k);
    cell = trimmed(rest.substr(k, end == std::string_view::npos ? end : end - k));
  }
  more = end != std::string_view::npos;
  rest = more ? rest.substr(end + 1) : std::string_view{};
  return true;
}

/// NaN and infinity are numbers of a broken run, and no header.
bool is_number(std::string_view cell) {
  if (parse_number(cell)) return true;
  std::string word = lower_case(cell);
  if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.erase(0, 1);
  return word == "nan" || word == "inf" || word == "infinity";
}

/// A word that no broken number begins with: "0,5" or "0x10" in a first row does not make it a header.
bool is_name(std::string_view cell) {
  if (cell.empty() || is_number(cell)) return false;
  const auto first = static_cast<unsigned char>(cell.front());
  return std::isalpha(first) || first >= 0x80 || first == '_' || first == '[' || first == '(';
}

/// False where tabs are mere blanks among others: between them stands nothing, or several numbers.
bool tabs_divide(std::string_view line) noexcept {
  for (;;) {
    const std::size_t tab = line.find('\t');
    const std::string_view cell = trimmed(line.substr(0, tab));
    if (cell.empty()) return false;
    const std::size_t blank = cell.find(' ');
    if (blank != std::string_view::npos && parse_number(cell.substr(0, blank))) return false;
    if (tab == std::string_view::npos) return true;
    line.remove_prefix(tab + 1);
  }
}

/// Names of columns in one line. Between blanks, what stands in brackets belongs to the name before it:
/// "x [mm] y [mm]" are two. Empty where a quote is not closed.
std::vector<std::string> names_in(std::string_view line, char delimiter) {
  std::vector<std::string_view> cells;
  std::vector<std::string> names;
  if (!split_cells(line, delimiter, cells)) return names;
  bool open = false;  // a bracket
  for (const std::string_view cell : cells) {
    const bool opens = delimiter == ' ' && !cell.empty() && (cell.front() == '[' || cell.front() == '(');
    if ((opens || open) && !names.empty())
      names.back() += fmt::format(" {}", cell);
    else
      names.emplace_back(cell);
    open = (opens || open) && cell.find_first_of("])") == std::string_view::npos;
  }
  return names;
}

/// A comment without what people put around names: "## x, y,", "#! x y", "# columns: x | y".
std::string without_marks(std::string_view comment) {
  constexpr std::string_view marks = "#%!;/*", blanks = " \t";
  while (!comment.empty() && (marks.find(comment.front()) != std::string_view::npos ||
                              blanks.find(comment.front()) != std::string_view::npos))
    comment.remove_prefix(1);
  const std::string_view first = comment.substr(0, comment.find_first_of(blanks));
  if (first.size() > 1 && first.back() == ':') comment = trimmed(comment.substr(first.size()));
  std::string out(comment);
  std::replace(out.begin(), out.end(), '|', ' ');
  while (!out.empty() && (out.back() == ',' || out.back() == ';' || out.back() == ' ')) out.pop_back();
  return out;
}

/// A name without the number of its column before it ("3:z") and signs behind it ("x,").
std::string without_number(std::string_view name) {
  const std::size_t colon = name.find(':');
  if (colon != std::string_view::npos && colon > 0 && parse_whole_number(name.substr(0, colon)))
    name.remove_prefix(colon + 1);
  while (!name.empty() && (name.back() == ',' || name.back() == ';')) name.remove_suffix(1);
  return std::string(name);
}

std::string delimiter_name(char delimiter) {
  constexpr std::string_view known = ",;\t ";
  constexpr std::array<const char*, 4> names = {"commas", "semicolons", "tabs", "blanks"};
  const auto place = known.find(delimiter);
  return place == std::string_view::npos ? in_quotes({&delimiter, 1}) : names[place];
}

/// What spreadsheets put into a cell that they cannot compute, as in "#DIV/0!" or "#NAME?": capitals between
/// a number sign and a mark, in any language. A row that begins with one is no comment.
bool begins_with_error(std::string_view line) noexcept {
  const std::size_t end = std::min(line.find_first_of(",;\t "), line.size());
  if (end < line.size() && line[end] == ' ') return false;  // prose
  const std::string_view cell = line.substr(0, end);
  if (cell == "#N/A" || cell == "#NV") return true;
  if (cell.size() < 4 || (cell.back() != '!' && cell.back() != '?')) return false;
  const std::string_view word = cell.substr(1, cell.size() - 2);
  return std::all_of(word.begin(), word.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return std::isupper(byte) || std::isdigit(byte) || byte >= 0x80 || c == '/' || c == '_';
  });
}

bool all_blank(const std::vector<std::string_view>& cells) {
  return std::all_of(cells.begin(), cells.end(), [](auto cell) { return cell.empty(); });
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (auto& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

bool split_cells(std::string_view line, char delimiter, std::vector<std::string_view>& cells) {
  cells.clear();
  std::string_view rest = delimiter == ' ' ? trimmed(line) : line, cell;
  for (bool more = true; more;) {
    if (!take_cell(rest, delimiter, cell, more)) return false;
    cells.push_back(cell);
    if (delimiter == ' ') rest = trimmed(rest);
  }
  return true;
}

char delimiter_of(std::string_view line) noexcept {
  line = trimmed(line);
  bool is_quoted = false, comma = false;
  for (const char c : line) {
    if (c == '"') is_quoted = !is_quoted;
    if (!is_quoted && c == ';') return ';';
    comma = comma || (!is_quoted && c == ',');
  }
  if (line.find('\t') != std::string_view::npos && tabs_divide(line)) return '\t';
  return comma ? ',' : ' ';
}

char stated_delimiter(std::string_view line) noexcept {
  constexpr std::string_view key = "sep=";
  while (!line.empty() && is_blank(line.back()) && line.size() > key.size() + 1) line.remove_suffix(1);
  return line.size() == key.size() + 1 && lower_case(line.substr(0, key.size())) == key ? line.back() : '\0';
}

bool is_comment_or_blank(std::string_view line) noexcept {
  line = trimmed(line);
  return line.empty() || line.front() == '%' || (line.front() == '#' && !begins_with_error(line));
}

HeaderRule header_of(std::vector<std::string> columns, std::size_t least) {
  const auto is_column = [columns = std::move(columns)](std::string_view word) {
    return std::find(columns.begin(), columns.end(), bare_name(word)) != columns.end();
  };
  const auto is_header = [is_column, least](const std::vector<std::string>& names) {
    const auto known = static_cast<std::size_t>(std::count_if(names.begin(), names.end(), is_column));
    return known >= std::min(least, names.size());
  };
  return {is_column, is_header};
}

DelimitedTable::DelimitedTable(std::string path, std::string_view text, const HeaderRule& rule)
    : path_(std::move(path)), lines_(text) {
  std::vector<Comment> comments;
  while (lines_.next() && is_comment_or_blank(lines_.line()))
    if (!trimmed(lines_.line()).empty()) comments.push_back({trimmed(lines_.line()), lines_.number()});
  const char stated = stated_delimiter(lines_.line());
  if (stated != '\0')
    while (lines_.next() && is_comment_or_blank(lines_.line())) {
    }
  first_text_ = lines_.line();
  first_line_ = line_ = lines_.number();
  delimiter_ = stated != '\0' ? stated : delimiter_of(first_text_);
  split(first_text_);
  width_ = cells_.size();
  if (std::any_of(cells_.begin(), cells_.end(), is_name) &&
      std::none_of(cells_.begin(), cells_.end(), is_number)) {
    names_ = names_in(first_text_, delimiter_);
    width_ = names_.size();
    return;
  }
  row_waits_ = !is_comment_or_blank(first_text_);
  first_row_ = first_text_;
  take_header_from(comments, rule);
}

/// What a comment may call the columns. The sign that begins it may be the name of the first: "#,x,y,z".
std::vector<std::vector<std::string>> DelimitedTable::names_of(std::string_view comment) const {
  std::vector<std::vector<std::string>> out;
  if (delimiter_ != ' ') out.push_back(names_in(comment, delimiter_));
  const std::string text = without_marks(comment);
  for (const char delimiter : {delimiter_, delimiter_of(text), ' '}) {
    out.push_back(names_in(text, delimiter));
    for (auto& name : out.back()) name = without_number(name);
  }
  return out;
}

void DelimitedTable::take_header_from(const std::vector<Comment>& comments, const HeaderRule& rule) {
  for (auto comment = comments.rbegin(); comment != comments.rend(); ++comment)
    for (auto& names : names_of(comment->text)) {
      if (!is_header(names, rule)) continue;
      names_ = std::move(names);
      width_ = names_.size();
      header_comment_ = comment->text;
      first_text_ = trimmed(comment->text.substr(1));
      first_line_ = comment->line;
      return;
    }
  if (!rule.is_column) return;
  for (const auto& comment : comments) {
    reject_half_a_header(comment, rule);
    for (const auto& names : names_of(comment.text))
      if (is_likely_header(names, rule)) likely_header_ = comment;
  }
}

bool DelimitedTable::could_be_header(const std::vector<std::string>& names) const {
  return (names.size() == width_ || (names.size() + 1 == width_ && ends_with_delimiter(first_row_))) &&
         std::all_of(names.begin(), names.end(),
                     [](const std::string& name) { return is_name(name) || name == "#"; });
}

bool DelimitedTable::is_header(const std::vector<std::string>& names, const HeaderRule& rule) const {
  if (!could_be_header(names)) return false;
  const auto states_unit = [](const std::string& name) {
    const std::string_view unit = split_bracketed_unit(name).unit;
    return !unit.empty() && !parse_number(unit);
  };
  return !rule.is_header || rule.is_header(names) || std::any_of(names.begin(), names.end(), states_unit);
}

bool DelimitedTable::is_likely_header(const std::vector<std::string>& names, const HeaderRule& rule) const {
  return could_be_header(names) &&
         2 * static_cast<std::size_t>(std::count_if(names.begin(), names.end(), rule.is_column)) >= width_;
}

void DelimitedTable::reject_half_a_header(const Comment& comment, const HeaderRule& rule) const {
  std::size_t known = 0;
  const auto names = names_in(without_marks(comment.text), ' ');
  while (known < names.size() && rule.is_column(without_number(names[known]))) ++known;
  if (known < 2 || known + 1 < width_) return;
  throw InputError(fmt::format(
      "{}:{}: the comment {} begins like a header of {} columns and goes on otherwise; let it hold one name "
      "for each "
      "column and nothing else, units in brackets behind the names (x [mm]), or begin it with another word",
      path_, comment.line, in_quotes(comment.text), width_));
}

/// np.savetxt into an open file writes its header again above every block.
void DelimitedTable::reject_second_header(std::string_view comment) const {
  if (header_comment_.empty() || comment != header_comment_) return;
  throw InputError(fmt::format(
      "{}:{}: the header {} of line {} stands again: what follows is another table, or another time step, "
      "which would lie on top of the first; keep one",
      path_, lines_.number(), in_quotes(comment), first_line_));
}

std::string DelimitedTable::where() const {
  return fmt::format("{}:{}", path_, line_);
}

std::string DelimitedTable::where_header() const {
  return fmt::format("{}:{}", path_, first_line_);
}

void DelimitedTable::split(std::string_view line) {
  if (!split_cells(line, delimiter_, cells_))
    throw InputError(
        fmt::format("{}: row {} has a quote that is not closed, or text beside a quoted cell; mend it",
                    where(), in_quotes(line)));
}

/// Programs end each row with a delimiter and not the header, or the other way round.
void DelimitedTable::take_last_delimiter_off(std::string_view line) {
  if (cells_.size() == width_ + 1 && ends_with_delimiter(line)) cells_.pop_back();
  if (cells_.size() + 1 == width_ && !names_.empty() && names_.back().empty()) cells_.emplace_back();
}

/// A comma at the end may stand before a cell that is empty, where one of the others is a decimal one; not
/// where blanks follow all of them.
bool DelimitedTable::ends_with_delimiter(std::string_view line) const {
  if (delimiter_ == ' ' || !cells_.back().empty()) return false;
  for (std::size_t k = 0; delimiter_ == ',' && k + 1 < line.size(); ++k)
    if (line[k] == ',' && !is_blank(line[k + 1])) return false;
  return true;
}

bool DelimitedTable::next() {
  if (std::exchange(row_waits_, false)) {
    take_last_delimiter_off(first_row_);
    return true;
  }
  while (lines_.next()) {
    if (is_comment_or_blank(lines_.line())) {
      reject_second_header(trimmed(lines_.line()));
      continue;
    }
    line_ = lines_.number();
    split(lines_.line());
    take_last_delimiter_off(lines_.line());
    if (cells_.size() == width_ && all_blank(cells_)) continue;  // as spreadsheets leave them below a table
    if (cells_.size() != width_)
      throw InputError(fmt::format(
          "{}: row '{}' has {} cells between {}, the {} has {}; every row needs all columns, divided alike, "
          "and numbers a decimal point, not a comma",
          where(), lines_.line().substr(0, 120), cells_.size(), delimiter_name(delimiter_),
          names_.empty() ? "first row" : "header", width_));
    return true;
  }
  return false;
}

}  // namespace superstep
