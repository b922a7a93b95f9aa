#include "packing/formats/xyz/xyz_comment.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/text/delimited.hpp"
#include "core/text/number.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/text_row.hpp"

namespace superstep {
namespace {

constexpr std::string_view blanks = " \t\r";

void skip_blanks(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
}

/// Takes so many characters off the front, and `more` that are thrown away.
std::string_view take(std::string_view& text, std::size_t count, std::size_t more = 0) {
  const std::string_view out = text.substr(0, count);
  text.remove_prefix(count >= text.size() ? text.size() : std::min(count + more, text.size()));
  return out;
}

/// Where the bracket that opens the text is closed.
std::size_t closing_bracket(std::string_view text) {
  int depth = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '[' || text[k] == '{') ++depth;
    if ((text[k] == ']' || text[k] == '}') && --depth == 0) return k;
  }
  return text.size();
}

/// Where the next quote is that no backslash stands before.
std::size_t closing_quote(std::string_view text, char quote) {
  std::size_t k = 0;
  while (k < text.size() && text[k] != quote) k += text[k] == '\\' ? 2 : 1;
  return std::min(k, text.size());
}

std::string_view take_value(std::string_view& text) {
  if (text.empty()) return {};
  const char first = text.front();
  if (first == '"' || first == '\'') {
    text.remove_prefix(1);
    return take(text, closing_quote(text, first), 1);
  }
  if (first != '[' && first != '{') return take(text, text.find_first_of(blanks));
  const std::size_t end = closing_bracket(text);
  return take(text, end, 1).substr(1);
}

/// Brackets and commas as blanks: what stands between them.
std::string without_brackets(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return std::string_view("[]{},").find(c) != std::string_view::npos; }, ' ');
  return text;
}

bool truth(const TextRow& row, std::size_t k) {
  for (const char* word : {"T", "True", "true", "TRUE", "1"})
    if (row[k] == word) return true;
  for (const char* word : {"F", "False", "false", "FALSE", "0"})
    if (row[k] == word) return false;
  throw InputError(fmt::format("{}: pbc holds {}; it must be T or F along each edge of the Lattice",
                               row.where(), in_quotes(row[k])));
}

/// What is periodic; nothing where it is not said.
std::optional<std::array<bool, 3>> periodic_of(const XyzPairs& pairs, TextRow& row, std::size_t line) {
  const auto pbc = pairs.find("pbc");
  if (pbc == pairs.end()) return std::nullopt;
  const std::string words = without_brackets(pbc->second);
  row.split(words, line);
  row.require_size(3, "T or F along each edge of the Lattice");
  return std::array{truth(row, 0), truth(row, 1), truth(row, 2)};
}

/// Rows or columns of a matrix in brackets may be meant as edges: a matrix in which they differ is refused.
void require_symmetric(const Cell& cell, const std::string& where) {
  const auto& [a, b, c] = cell.edge;
  if (a.y == b.x && a.z == c.x && b.z == c.y) return;
  throw InputError(fmt::format(
      "{}: Lattice is a matrix in brackets, whose rows and whose columns would be different boxes; "
      "write its edges one after the other, as in Lattice=\"ax ay az bx by bz cx cy cz\"",
      where));
}

}  // namespace

XyzPairs xyz_pairs(std::string_view comment) {
  XyzPairs out;
  for (skip_blanks(comment); !comment.empty(); skip_blanks(comment)) {
    const bool quoted = comment.front() == '"';
    const std::string_view key =
        quoted ? take_value(comment) : take(comment, comment.find_first_of(" \t\r="));
    skip_blanks(comment);
    if (comment.empty() || comment.front() != '=') continue;
    comment.remove_prefix(1);
    skip_blanks(comment);
    out.emplace(lower_case(key), std::string(take_value(comment)));
  }
  return out;
}

std::optional<Cell> xyz_cell(const XyzPairs& pairs, const std::string& path, std::size_t line) {
  TextRow row(path);
  const auto periodic = periodic_of(pairs, row, line);
  const auto lattice = pairs.find("lattice");
  if (lattice == pairs.end()) {
    if (periodic && ((*periodic)[0] || (*periodic)[1] || (*periodic)[2]))
      throw InputError(
          fmt::format("{}:{}: pbc says what is periodic, and there is no Lattice; add "
                      "Lattice=\"ax ay az bx by bz cx cy cz\", or write pbc=\"F F F\"",
                      path, line));
    return std::nullopt;
  }
  const auto vector = [&](std::size_t k) {
    return Vec3{row.number(k, "Lattice"), row.number(k + 1, "Lattice"), row.number(k + 2, "Lattice")};
  };
  const std::string edges = without_brackets(lattice->second);
  row.split(edges, line);
  row.require_size(9, "the three edges of the Lattice");
  Cell cell{.origin = {}, .edge = {vector(0), vector(3), vector(6)}, .periodic = {true, true, true}};
  if (lattice->second.find('[') != std::string::npos) require_symmetric(cell, row.where());
  const auto origin = pairs.find("origin");
  const std::string corner = origin == pairs.end() ? "" : without_brackets(origin->second);
  if (origin != pairs.end()) {
    row.split(corner, line);
    row.require_size(3, "the corner of the Lattice");
    cell.origin = vector(0);
  }
  if (periodic) cell.periodic = *periodic;
  return cell;
}

std::vector<std::string> xyz_property_names(const std::string& properties, const std::string& place) {
  std::vector<std::string> parts;
  std::string_view rest = properties;
  for (bool more = true; more;) {
    const std::size_t end = rest.find(':');
    parts.emplace_back(rest.substr(0, end));
    more = end != std::string_view::npos;
    if (more) rest = rest.substr(end + 1);
  }
  std::vector<std::string> names;
  constexpr std::int64_t most = 1000;  // columns of one property; more is a slip
  for (std::size_t k = 0; k < parts.size(); k += 3) {
    const auto count = k + 2 < parts.size() ? parse_integer(parts[k + 2]) : std::nullopt;
    if (!count || *count < 1 || *count > most)
      throw InputError(
          fmt::format("{}: Properties is {}; it must be triples of name, kind and number of columns, as in "
                      "species:S:1:pos:R:3:radius:R:1",
                      place, in_quotes(properties)));
    for (std::int64_t c = 0; c < *count; ++c)
      names.push_back(*count == 1 ? parts[k] : fmt::format("{}:{}", parts[k], c));
  }
  return names;
}

}  // namespace superstep
