/// Yade text: spheres as `yade.export` writes them.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/recognise.hpp"
#include "packing/formats/sphere_rows.hpp"
#include "packing/formats/text_row.hpp"

namespace superstep {
namespace {

constexpr std::string_view format_word = "#format";

bool recognises(const PackingFile& file) {
  BeginningLines lines(file);
  while (lines.next())
    if (lines.row()[0] == format_word) return true;
  return false;
}

/// Names of the columns as in x_y_z_r_clumpId; "attrs" stands for as many as there are.
struct YadeColumns {
  std::vector<std::string> names;
  bool any_more = false;
};

YadeColumns parse_format(const TextRow& line) {
  YadeColumns columns;
  std::string_view rest = line.size() == 2 ? line[1] : std::string_view{};
  while (!rest.empty()) {
    const std::size_t end = rest.find('_');
    columns.names.emplace_back(rest.substr(0, end));
    rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
  }
  if (!columns.names.empty() && columns.names.back() == "attrs") {
    columns.names.pop_back();
    columns.any_more = true;
  }
  for (const char* needed : {"x", "y", "z", "r"})
    if (std::find(columns.names.begin(), columns.names.end(), needed) == columns.names.end())
      throw InputError(
          fmt::format("{}: format is {}; it must hold x, y, z and r, as in x_y_z_r, x_y_z_r_matId, "
                      "x_y_z_r_clumpId or x_y_z_r_attrs; export the packing as one of these",
                      line.where(), in_quotes(line.size() > 1 ? line[1] : std::string_view{})));
  return columns;
}

/// Attributes are named by the last comment above the rows: it has a word for each, or for each column.
void name_attributes(std::vector<std::string> words, std::size_t width, YadeColumns& columns) {
  if (!columns.any_more || width < columns.names.size()) return;
  const std::size_t more = width - columns.names.size();
  if (words.size() == width && std::equal(columns.names.begin(), columns.names.end(), words.begin()))
    words.erase(words.begin(), words.end() - static_cast<std::ptrdiff_t>(more));
  for (std::size_t k = 0; k < more; ++k)
    columns.names.push_back(words.size() == more ? words[k] : fmt::format("attr{}", k + 1));
}

Packing read(const PackingFile& file) {
  LineReader lines(file.content);
  TextRow row(file.path);
  YadeColumns columns;
  std::string place;
  std::vector<std::string> words;
  std::optional<SphereRows> rows;
  while (lines.next()) {
    row.split(lines.line(), lines.number());
    if (row.size() == 0) continue;
    if (row[0] == format_word) {
      if (rows)
        throw InputError(fmt::format(
            "{}: a line #format follows particles; it must stand above them, once: two exports in one file "
            "are two packings",
            row.where()));
      columns = parse_format(row);
      place = row.where();
      continue;
    }
    if (row[0].front() == '#') {
      std::string_view comment = trimmed(trimmed(lines.line()).substr(1));
      TextRow split(file.path);
      split.split(comment, lines.number());
      words.assign(split.cells().begin(), split.cells().end());
      continue;
    }
    if (!rows) {
      if (place.empty())
        throw InputError(
            fmt::format("{}: particles stand above the line #format; it must be the first", row.where()));
      name_attributes(words, row.size(), columns);
      rows.emplace(file, SphereLayout{.names = columns.names, .place = place, .header = "the line #format"});
    }
    row.require_size(columns.names.size(), "those of the line #format");
    rows->add(row.cells(), row.line());
  }
  if (!rows)
    throw InputError(fmt::format("{}: has a header but no particles; at least one is needed", file.path));
  Packing packing = rows->finish();
  if (find_attribute(packing, "clumpId") != nullptr)
    packing.notes.push_back("members of a clump are spheres of their own, in contact where they overlap");
  return packing;
}

}  // namespace

PackingFormat yade_format() {
  return {"Yade text", recognises, read, true, true};
}

}  // namespace superstep
