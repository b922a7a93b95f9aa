#include "packing/formats/stated.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/text/delimited.hpp"
#include "core/text/number.hpp"
#include "core/text/quantity.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/text_row.hpp"
#include "packing/units.hpp"

namespace superstep {

std::optional<StatedValue> stated_value(std::string_view text, std::string_view key) {
  LineReader lines(text);
  int rows = 0;  // a header, and the first row below it
  while (rows < 2 && lines.next()) {
    std::string_view line = trimmed(lines.line());
    if (line.empty()) continue;
    if (line.front() != '#' && line.front() != '%') {
      ++rows;
      continue;
    }
    line = trimmed(line.substr(1));
    if (lower_case(line.substr(0, key.size())) != key) continue;
    line = trimmed(line.substr(key.size()));
    if (line.empty() || (line.front() != '=' && line.front() != ':')) continue;
    line = trimmed(line.substr(1));
    if (line.size() >= 2 && line.front() == '"' && line.back() == '"') line = line.substr(1, line.size() - 2);
    return StatedValue{std::string(line), lines.number()};
  }
  return std::nullopt;
}

std::optional<StatedUnit> stated_length_unit(const std::string& path, std::string_view text) {
  const auto stated = stated_value(text, "length_unit");
  if (!stated) return std::nullopt;
  return StatedUnit{length_unit(stated->text, fmt::format("{}:{}", path, stated->line)),
                    fmt::format("{}, as line {} says", stated->text, stated->line)};
}

std::optional<StatedValue> mentioned_length_unit(std::string_view text) {
  constexpr std::string_view between = " \t,;:=()[]{}|\"'#%!";
  LineReader lines(text);
  while (lines.next() && is_comment_or_blank(lines.line())) {
    std::string_view rest = lines.line();
    while (!rest.empty()) {
      const std::string_view word = rest.substr(0, rest.find_first_of(between));
      rest.remove_prefix(std::min(word.size() + 1, rest.size()));
      const auto metres = length_unit_of_column(lower_case(word));
      if (metres && *metres < 1) return StatedValue{std::string(word), lines.number()};
    }
  }
  return std::nullopt;
}

std::array<bool, 3> periodic_edges(const std::string& word, const std::string& where) {
  std::array<bool, 3> edges{};
  if (word == "none") return edges;
  for (const char c : word) {
    const auto axis = std::string_view("xyz").find(c);
    if (axis == std::string_view::npos || edges[axis])
      throw InputError(fmt::format("{}: periodic is {}; it must be auto, none, or axes such as x, xy, xyz",
                                   where, in_quotes(word)));
    edges[axis] = true;
  }
  if (word.empty())
    throw InputError(
        fmt::format("{}: periodic is ''; it must be auto, none, or axes such as x, xy, xyz", where));
  return edges;
}

std::optional<Cell> stated_cell(const PackingFile& file) {
  const auto stated = stated_value(file.content, "cell"), periodic = stated_value(file.content, "periodic");
  if (!stated) {
    if (periodic)
      throw InputError(
          fmt::format("{}:{}: states what is periodic without a cell; add # cell = \"ox oy oz ax ay az bx by "
                      "bz cx cy cz\", or remove it",
                      file.path, periodic->line));
    return std::nullopt;
  }
  const auto refuse = [&](const std::string& what) {
    throw InputError(
        fmt::format("{}:{}: the comment '# cell' {}; it must be the corner and the three edges, # "
                    "cell = \"ox oy oz ax ay az bx by bz cx cy cz\"",
                    file.path, stated->line, what));
  };
  TextRow row(file.path);
  row.split(stated->text, stated->line);
  if (row.size() != 12) refuse("has " + quantity(row.size(), "number"));
  const auto number = [&](std::size_t k) {
    const auto value = parse_number(row[k]);
    if (!value) refuse(fmt::format("has {}, which is no finite decimal number", in_quotes(row[k])));
    return *value;
  };
  const auto vector = [&](std::size_t k) { return Vec3{number(k), number(k + 1), number(k + 2)}; };
  Cell cell{.origin = vector(0), .edge = {vector(3), vector(6), vector(9)}, .periodic = {}};
  if (periodic)
    cell.periodic = periodic_edges(periodic->text, fmt::format("{}:{}", file.path, periodic->line));
  return cell;
}

std::string cell_comment(const Cell& cell) {
  std::string out = fmt::format("# cell = \"{} {} {}", cell.origin.x, cell.origin.y, cell.origin.z);
  for (const auto& edge : cell.edge) out += fmt::format(" {} {} {}", edge.x, edge.y, edge.z);
  return out + fmt::format("\"\n# periodic = \"{}\"\n", cell.periodic_axes());
}

}  // namespace superstep
