#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/packing_builder.hpp"
#include "packing/formats/text_row.hpp"

namespace superstep {
namespace {

constexpr std::string_view frame_start = "ITEM: TIMESTEP", count_item = "ITEM: NUMBER OF ATOMS",
                           atoms_item = "ITEM: ATOMS";

/// Where the last frame begins.
std::size_t last_frame(const PackingFile& file) {
  const std::size_t start = file.text.rfind(frame_start);
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
  for (std::size_t at = 0; (at = file.text.find(frame_start, at)) != std::string_view::npos; ++at) ++frames;
  if (frames < 2) return {};
  lines.next();
  const bool dated = lines.next();
  return fmt::format("the last of {} frames, time step {}", frames, dated ? trimmed(lines.line()) : "?");
}

/// Places of the columns that a packing needs.
struct Columns {
  std::optional<std::size_t> id, type;
  std::size_t x = 0, y = 0, z = 0, size = 0;
  bool size_is_diameter = false;
  std::size_t width = 0;
};

Columns find_columns(const TextRow& header) {
  constexpr std::size_t words = 2;  // "ITEM:" "ATOMS"
  const auto find = [&](std::string_view name) -> std::optional<std::size_t> {
    for (std::size_t k = words; k < header.size(); ++k)
      if (header[k] == name) return k - words;
    return std::nullopt;
  };
  const auto need = [&](std::string_view name) {
    const auto place = find(name);
    if (!place)
      throw InputError(
          fmt::format("{}: column '{}' is missing from 'ITEM: ATOMS'; a packing needs x y z and radius or "
                      "diameter (and id, type if there are several): add it to the dump command",
                      header.where(), name));
    return *place;
  };
  Columns columns;
  columns.x = need("x");
  columns.y = need("y");
  columns.z = need("z");
  columns.size_is_diameter = !find("radius") && find("diameter");
  columns.size = need(columns.size_is_diameter ? "diameter" : "radius");
  columns.id = find("id");
  columns.type = find("type");
  columns.width = header.size() - words;
  return columns;
}

void add_atom(PackingBuilder& builder, const TextRow& row, const Columns& columns) {
  row.require_size(columns.width, "those that 'ITEM: ATOMS' names");
  const auto id = columns.id ? row.integer(*columns.id, "id") : static_cast<std::int64_t>(builder.size());
  const Vec3 centre{row.number(columns.x, "x"), row.number(columns.y, "y"), row.number(columns.z, "z")};
  const double radius = columns.size_is_diameter ? 0.5 * row.number(columns.size, "diameter")
                                                 : row.number(columns.size, "radius");
  builder.add(row.line(), id, centre, radius);
  if (columns.type) builder.set_material(row[*columns.type]);
}

}  // namespace

Packing read_lammps_dump(const PackingFile& file) {
  const std::size_t start = last_frame(file);
  const auto skipped = static_cast<std::size_t>(
      std::count(file.text.begin(), file.text.begin() + static_cast<std::ptrdiff_t>(start), '\n'));
  LineReader lines(file.text.substr(start));
  TextRow row(file.path);
  PackingBuilder builder(file.path, file.unit);
  std::optional<std::int64_t> expected;
  std::optional<Columns> columns;
  while (lines.next()) {
    row.split(lines.line(), skipped + lines.number());
    if (row.size() == 0) continue;
    if (columns) {
      add_atom(builder, row, *columns);
    } else if (lines.line().starts_with(count_item) && lines.next()) {
      row.split(lines.line(), skipped + lines.number());
      row.require_size(1, "the number of atoms");
      expected = row.integer(0, "number of atoms");
    } else if (lines.line().starts_with(atoms_item)) {
      columns = find_columns(row);
    }
  }
  if (!expected)
    throw InputError(
        fmt::format("{}: the last frame has no '{}', which tells whether it is whole; write the dump again",
                    file.path, count_item));
  if (*expected != static_cast<std::int64_t>(builder.size()))
    throw InputError(
        fmt::format("{}:{}: the last frame ends after {} atoms; it announces {}; the file is cut off or "
                    "edited: remove that frame or write the dump again",
                    file.path, row.line(), builder.size(), *expected));
  builder.drop_single_material();
  Packing packing = builder.finish();
  packing.frame = frame_name(file, LineReader(file.text.substr(start)));
  return packing;
}

}  // namespace superstep
