/// LAMMPS/LIGGGHTS dump: text that `dump custom` and `dump atom` write.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/recognise.hpp"
#include "packing/formats/sphere_rows.hpp"
#include "packing/formats/text_row.hpp"
#include "packing/units.hpp"

namespace superstep {
namespace {

constexpr std::string_view frame_start = "ITEM: TIMESTEP", count_item = "ITEM: NUMBER OF ATOMS",
                           box_item = "ITEM: BOX BOUNDS", atoms_item = "ITEM: ATOMS",
                           units_item = "ITEM: UNITS";

bool recognises(const PackingFile& file) {
  BeginningLines lines(file);
  return lines.next_statement() && lines.row()[0] == "ITEM:";
}

/// Where the last frame begins.
std::size_t last_frame(const PackingFile& file) {
  const std::size_t start = file.content.rfind(frame_start);
  if (start == std::string_view::npos)
    throw InputError(
        fmt::format("{}: no line '{}' although it begins like a LAMMPS dump; write the dump again", file.path,
                    frame_start));
  return start;
}

/// "the last of 3 frames, time step 2000"; empty where there is one.
///   lines  from the beginning of the last frame on
std::string frame_name(const PackingFile& file, LineReader lines) {
  std::size_t frames = 0;
  for (std::size_t at = 0; (at = file.content.find(frame_start, at)) != std::string_view::npos; ++at)
    ++frames;
  if (frames < 2) return {};
  lines.next();
  const bool dated = lines.next();
  return fmt::format("the last of {} frames, time step {}", frames, dated ? trimmed(lines.line()) : "?");
}

/// The unit style behind the last `ITEM: UNITS`: a program writes it once, before its first frame, but dumps
/// of several programs may follow each other in a file.
std::optional<StatedUnit> stated_unit(const PackingFile& file) {
  const std::size_t at = file.content.rfind(units_item);
  if (at == std::string_view::npos) return std::nullopt;
  const auto line =
      1 + std::count(file.content.begin(), file.content.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  LineReader lines(file.content.substr(at));
  lines.next();
  lines.next();
  const std::string style(trimmed(lines.line()));
  const auto metres = unit_style_length(style);
  if (!metres)
    throw InputError(
        fmt::format("{}:{}: the units are {}, which is no unit style of LAMMPS; mend the line, or remove it "
                    "and give length_unit",
                    file.path, line + 1, in_quotes(style)));
  return StatedUnit{*metres, fmt::format("units {}, as line {} says", style, line + 1), style};
}

/// `ITEM: BOX BOUNDS` with its three lines: orthogonal, tilted (xy xz yz), or three free edges (abc origin).
Cell read_box(TextRow& row, LineReader& lines, std::size_t skipped) {
  constexpr std::size_t words = 3;  // "ITEM:" "BOX" "BOUNDS"
  Cell cell;
  bool tilted = false, free_edges = false;
  std::size_t axis = 0;
  for (std::size_t k = words; k < row.size(); ++k) {
    tilted = tilted || row[k] == "xy";
    free_edges = free_edges || row[k] == "abc";
    const bool is_boundary = row[k].size() == 2 &&
                             std::string_view("pfsm").find(row[k][0]) != std::string_view::npos &&
                             std::string_view("pfsm").find(row[k][1]) != std::string_view::npos;
    if (is_boundary && axis < 3) cell.periodic[axis++] = row[k] == "pp";
  }
  std::array<std::array<double, 4>, 3> bound{};
  const std::size_t columns = free_edges ? 4 : tilted ? 3 : 2;
  for (auto& one : bound) {
    if (!lines.next())
      throw InputError(fmt::format(
          "{}: the file ends inside 'ITEM: BOX BOUNDS'; it is cut off: write the dump again", row.where()));
    row.split(lines.line(), skipped + lines.number());
    row.require_size(columns, "the bounds of the box along one axis");
    for (std::size_t k = 0; k < columns; ++k) one[k] = row.number(k, "box bounds");
  }
  if (free_edges) {
    cell.origin = {bound[0][3], bound[1][3], bound[2][3]};
    for (std::size_t k = 0; k < 3; ++k) cell.edge[k] = {bound[k][0], bound[k][1], bound[k][2]};
    return cell;
  }
  // The bounds of a tilted box are those of what encloses it. Source: LAMMPS manual, "Howto triclinic".
  const double xy = bound[0][2], xz = bound[1][2], yz = bound[2][2];
  const double x0 = bound[0][0] - std::min({0.0, xy, xz, xy + xz}),
               x1 = bound[0][1] - std::max({0.0, xy, xz, xy + xz});
  const double y0 = bound[1][0] - std::min(0.0, yz), y1 = bound[1][1] - std::max(0.0, yz);
  cell.origin = {x0, y0, bound[2][0]};
  cell.edge = {Vec3{x1 - x0, 0, 0}, Vec3{xy, y1 - y0, 0}, Vec3{xz, yz, bound[2][1] - bound[2][0]}};
  return cell;
}

SphereLayout layout_of(const TextRow& header, const std::optional<Cell>& cell,
                       std::optional<StatedUnit> unit) {
  constexpr std::size_t words = 2;  // "ITEM:" "ATOMS"
  SphereLayout layout;
  for (std::size_t k = words; k < header.size(); ++k) layout.names.emplace_back(header[k]);
  layout.place = header.where();
  layout.header = "'ITEM: ATOMS'";
  layout.rules.lammps = true;
  layout.cell = cell;
  layout.cell_binds = cell.has_value();
  layout.unit = std::move(unit);
  return layout;
}

Packing read(const PackingFile& file) {
  const std::size_t start = last_frame(file);
  const auto skipped = static_cast<std::size_t>(
      std::count(file.content.begin(), file.content.begin() + static_cast<std::ptrdiff_t>(start), '\n'));
  LineReader lines(file.content.substr(start));
  TextRow row(file.path);
  std::optional<std::int64_t> expected;
  std::optional<Cell> cell;
  std::optional<SphereRows> rows;
  std::size_t width = 0;
  while (lines.next()) {
    row.split(lines.line(), skipped + lines.number());
    if (row.size() == 0) continue;
    if (rows) {
      row.require_size(width, "those that 'ITEM: ATOMS' names");
      rows->add(row.cells(), row.line());
    } else if (lines.line().starts_with(count_item) && lines.next()) {
      row.split(lines.line(), skipped + lines.number());
      row.require_size(1, "the number of atoms");
      expected = row.integer(0, "number of atoms");
    } else if (lines.line().starts_with(box_item)) {
      cell = read_box(row, lines, skipped);
    } else if (lines.line().starts_with(atoms_item)) {
      SphereLayout layout = layout_of(row, cell, stated_unit(file));
      width = layout.names.size();
      rows.emplace(file, std::move(layout));
    }
  }
  if (!expected)
    throw InputError(
        fmt::format("{}: the last frame has no '{}', which tells whether it is whole; write the dump again",
                    file.path, count_item));
  const std::size_t found = rows ? rows->size() : 0;
  if (*expected != static_cast<std::int64_t>(found))
    throw InputError(
        fmt::format("{}:{}: the last frame ends after {} atoms; it announces {}; the file is cut off or "
                    "edited: remove that frame or write the dump again",
                    file.path, row.line(), found, *expected));
  if (!rows)
    throw InputError(fmt::format("{}: has a header but no particles; at least one is needed", file.path));
  Packing packing = rows->finish();
  packing.frame = frame_name(file, LineReader(file.content.substr(start)));
  return packing;
}

}  // namespace

PackingFormat lammps_dump_format() {
  return {"LAMMPS/LIGGGHTS dump", recognises, read, true, true};
}

}  // namespace superstep
