/// LAMMPS/LIGGGHTS data: what `write_data` writes and `read_data` reads.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <optional>
#include <unordered_map>

#include "core/error.hpp"
#include "core/text/delimited.hpp"
#include "core/text/number.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/atom_styles.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/plausible_layout.hpp"
#include "packing/formats/recognise.hpp"
#include "packing/formats/sphere_rows.hpp"
#include "packing/formats/text_row.hpp"
#include "packing/units.hpp"

namespace superstep {
namespace {

bool recognises(const PackingFile& file) {
  BeginningLines lines(file);
  while (lines.next())
    if (lines.row().size() >= 2 && lines.row()[1] == "atoms" && parse_integer(lines.row()[0])) return true;
  return false;
}

/// Headings are words. "nan" and "inf" are what a writer makes of a broken number: they begin a row.
bool is_heading(const TextRow& row) {
  const std::string first = lower_case(row[0]);
  if (first == "nan" || first == "inf" || first == "infinity") return false;
  for (std::size_t k = 0; k < row.size(); ++k)
    if (!std::isalpha(static_cast<unsigned char>(row[k].front()))) return false;
  return true;
}

/// "units = si" in the title that write_data writes.
std::optional<StatedUnit> unit_in_title(std::string_view title) {
  constexpr std::string_view key = "units = ";
  const std::size_t at = title.find(key);
  if (at == std::string_view::npos) return std::nullopt;
  std::string_view style = title.substr(at + key.size());
  const std::string name(style.substr(0, style.find_first_of(" ,\t")));
  const auto metres = unit_style_length(name);
  if (!metres) return std::nullopt;
  return StatedUnit{*metres, fmt::format("units {}, as the title says", name), name};
}

/// Everything above the rows of section Atoms.
struct DataHead {
  std::int64_t atoms = 0, types = 0;
  std::optional<Cell> cell;
  std::optional<StatedUnit> unit;
  std::string style;                     ///< behind "Atoms #"
  std::string place;                     ///< of the heading
  std::string shapes;                    ///< a section of particles that are no spheres; empty = none
  LineReader rows{""};                   ///< before the first of them
  std::optional<LineReader> velocities;  ///< the same of section Velocities
};

void read_header_line(const TextRow& row, Cell& cell, DataHead& head) {
  const auto ends_with = [&](std::initializer_list<const char*> words) {
    if (row.size() < words.size()) return false;
    std::size_t k = row.size() - words.size();
    for (const char* word : words)
      if (row[k++] != word) return false;
    return true;
  };
  const auto bounds = [&](std::size_t axis, double Vec3::*component) {
    row.require_size(4, "the bounds of the box along one axis");
    const double low = row.number(0, "box bounds"), high = row.number(1, "box bounds");
    cell.origin.*component = low;
    cell.edge[axis].*component = high - low;
    head.cell = cell;
  };
  const auto vector = [&](Vec3& out) {
    for (std::size_t k = 0; k < 3; ++k) (k == 0 ? out.x : k == 1 ? out.y : out.z) = row.number(k, "box edge");
    head.cell = cell;
  };
  if (row.size() == 2 && row[1] == "atoms") head.atoms = row.integer(0, "number of atoms");
  if (ends_with({"atom", "types"})) head.types = row.integer(0, "number of atom types");
  if (ends_with({"xlo", "xhi"})) bounds(0, &Vec3::x);
  if (ends_with({"ylo", "yhi"})) bounds(1, &Vec3::y);
  if (ends_with({"zlo", "zhi"})) bounds(2, &Vec3::z);
  if (ends_with({"xy", "xz", "yz"}) && row.size() == 6) {
    cell.edge[1].x = row.number(0, "xy");
    cell.edge[2].x = row.number(1, "xz");
    cell.edge[2].y = row.number(2, "yz");
    head.cell = cell;
  }
  if (row.size() == 4 && row[3] == "avec") vector(cell.edge[0]);
  if (row.size() == 4 && row[3] == "bvec") vector(cell.edge[1]);
  if (row.size() == 4 && row[3] == "cvec") vector(cell.edge[2]);
  if (ends_with({"abc", "origin"}) && row.size() == 5) vector(cell.origin);
}

std::string_view without_comment(std::string_view line) {
  return line.substr(0, line.find('#'));
}

DataHead read_head(const PackingFile& file) {
  LineReader lines(file.content);
  TextRow row(file.path);
  DataHead head;
  Cell cell;
  bool in_section = false;
  lines.next();  // the first line is a title, whatever it says
  head.unit = unit_in_title(lines.line());
  while (lines.next()) {
    row.split(without_comment(lines.line()), lines.number());
    if (row.size() == 0) continue;
    if (is_heading(row)) {
      in_section = true;
      if (row.size() == 1 && row[0] == "Velocities") head.velocities = lines;
      for (const char* shapes : {"Ellipsoids", "Lines", "Triangles", "Bodies"})
        if (row.size() == 1 && row[0] == shapes) head.shapes = shapes;
      if (row.size() != 1 || row[0] != "Atoms") continue;
      if (!head.place.empty())
        throw InputError(fmt::format("{}: section 'Atoms' stands twice; keep one", row.where()));
      head.place = row.where();
      head.rows = lines;
      const std::size_t sharp = lines.line().find('#');
      if (sharp != std::string_view::npos) head.style = trimmed(lines.line().substr(sharp + 1));
    } else if (!in_section) {
      read_header_line(row, cell, head);
    }
  }
  return head;
}

/// Calls each(row) for every row of the section that `lines` stands before; returns the last line looked at.
template <class Each>
std::size_t for_rows(const PackingFile& file, LineReader lines, Each each) {
  TextRow row(file.path);
  while (lines.next()) {
    row.split(without_comment(lines.line()), lines.number());
    if (row.size() == 0) continue;
    if (is_heading(row)) break;
    each(row);
  }
  return lines.number();
}

/// Section Velocities, id vx vy vz and whatever follows, as attributes of the particles.
void read_velocities(const PackingFile& file, const LineReader& lines, Packing& packing) {
  std::unordered_map<std::int64_t, std::size_t> place;
  for (std::size_t k = 0; k < packing.size(); ++k) place.emplace(packing.id[k], k);
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  for (const char* name : {"vx", "vy", "vz"})
    packing.attributes.push_back({name, std::vector<double>(packing.size(), gap)});
  const auto first = packing.attributes.end() - 3;
  for_rows(file, lines, [&](const TextRow& row) {
    if (row.size() < 4) row.require_size(4, "id vx vy vz");
    const auto found = place.find(row.integer(0, "id"));
    if (found == place.end())
      throw InputError(fmt::format("{}: section 'Velocities' names atom {}, which section 'Atoms' has not",
                                   row.where(), row[0]));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      auto& column = first[static_cast<std::ptrdiff_t>(axis)];
      column.value[found->second] = row.number(axis + 1, column.name);
    }
  });
  packing.notes.emplace_back("section Velocities is kept as attributes: vx, vy, vz");
}

/// The order of the columns: as declared, as the file says, or the only one that makes sense of every row.
AtomLayout choose_layout(const PackingFile& file, const DataHead& head, bool& recognised) {
  if (!file.options.columns.empty()) return {"declared", file.options.columns};
  if (!file.options.atom_style.empty())
    return atom_layout(file.options.atom_style, file.options.place.empty() ? file.path : file.options.place);
  if (!head.style.empty() && head.style != "hybrid") return atom_layout(head.style, head.place);
  recognised = true;
  // Their styles put a flag and a density, or a mass, where spheres have a diameter and a density.
  if (head.style.empty() && !head.shapes.empty())
    throw InputError(
        fmt::format("{}: section 'Atoms' does not name its style, and section '{}' says that there are other "
                    "shapes than spheres; declare the style in [packing], as in atom_style = \"sphere\"",
                    head.place, head.shapes));
  PlausibleLayout plausible(head.cell, head.types, head.style == "hybrid");
  std::size_t first_line = 0;
  for_rows(file, head.rows, [&](const TextRow& row) {
    if (first_line == 0) first_line = row.line();
    plausible.look_at(row.cells());
  });
  return plausible.choose(fmt::format("{}:{}", file.path, first_line));
}

/// The user may overrule the style that the file states, which may be wrong.
void warn_of_other_style(const DataHead& head, const AtomLayout& layout, Packing& packing) {
  if (head.style.empty() || head.style == "hybrid" || head.style == layout.style) return;
  packing.warnings.push_back(
      fmt::format("{}: section Atoms states the style {}; its columns are read as [packing] says: {}",
                  head.place, head.style, fmt::join(layout.columns, " ")));
}

Packing read(const PackingFile& file) {
  const DataHead head = read_head(file);
  bool recognised = false;
  AtomLayout layout = choose_layout(file, head, recognised);
  const std::size_t plain = layout.columns.size(), with_image_flags = plain + 3;
  SphereLayout sphere{.names = layout.columns,
                      .place = head.place.empty() ? file.path : head.place,
                      .header = fmt::format("the order of atom style {}", layout.style),
                      .cell = head.cell,
                      .cell_binds = head.cell.has_value(),
                      .unit = head.unit};
  SphereRows rows(file, std::move(sphere));
  const std::string order = fmt::format("{}, and three image flags if any", fmt::join(layout.columns, " "));
  const std::size_t last = for_rows(file, head.rows, [&](const TextRow& row) {
    if (row.size() != with_image_flags) row.require_size(plain, order);
    rows.add(std::span(row.cells()).first(plain), row.line());
  });
  if (head.atoms != static_cast<std::int64_t>(rows.size()))
    throw InputError(
        fmt::format("{}:{}: section 'Atoms' has {} rows; the header announces {} atoms; the file is cut off "
                    "or edited: write it again",
                    file.path, last, rows.size(), head.atoms));
  Packing packing = rows.finish();
  packing.notes.insert(
      packing.notes.begin(),
      fmt::format("order of the columns: {} (atom style {}{})", fmt::join(layout.columns, " "), layout.style,
                  recognised ? ", the only one that fits every row" : ""));
  if (!recognised) warn_of_other_style(head, layout, packing);
  if (head.velocities) read_velocities(file, *head.velocities, packing);
  if (head.cell && file.options.periodic == "auto")
    packing.notes.push_back(
        "a data file does not say whether its box is periodic: taken as open; periodic = \"xyz\" "
        "joins its sides");
  return packing;
}

}  // namespace

PackingFormat lammps_data_format() {
  return {"LAMMPS/LIGGGHTS data", recognises, read, false, true};
}

}  // namespace superstep
