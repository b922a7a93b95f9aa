/// MercuryDPM .data, in two or three dimensions.

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text/number.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/recognise.hpp"
#include "packing/formats/sphere_rows.hpp"
#include "packing/formats/text_row.hpp"

namespace superstep {
namespace {

/// A header and the rows below it.
struct Kind {
  bool flat;
  std::size_t header_size;
  const char* header;
  std::vector<std::string> columns;
};

const Kind& three_dimensions() {
  static const Kind kind{false,
                         8,
                         "N t xmin ymin zmin xmax ymax zmax, the header of a frame",
                         {"x", "y", "z", "vx", "vy", "vz", "radius", "alpha", "beta", "gamma", "omega_x",
                          "omega_y", "omega_z", "species"}};
  return kind;
}

const Kind& two_dimensions() {
  static const Kind kind{true,
                         6,
                         "N t xmin ymin xmax ymax, the header of a frame in two dimensions",
                         {"x", "y", "vx", "vy", "radius", "angle", "omega", "species"}};
  return kind;
}

const Kind* kind_of(const TextRow& header) {
  for (const Kind* kind : {&three_dimensions(), &two_dimensions()})
    if (header.size() == kind->header_size) return kind;
  return nullptr;
}

/// A header of numbers that begins with a count. A table could look like it, so that the row below must fit;
/// frames without particles have none.
bool recognises(const PackingFile& file) {
  BeginningLines lines(file);
  if (!lines.next_statement() || !all_numbers(lines.row())) return false;
  const Kind* kind = kind_of(lines.row());
  if (kind == nullptr || !parse_integer(lines.row()[0])) return false;
  while (parse_integer(lines.row()[0]) == 0) {
    if (!lines.next()) return !kind->flat;
    if (lines.row().size() != kind->header_size || !all_numbers(lines.row())) return false;
  }
  return parse_integer(lines.row()[0]) && lines.next() && lines.row().size() == kind->columns.size();
}

struct Frame {
  LineReader rows;  // before the first of them
  std::int64_t count = 0;
  std::size_t number = 0;  // counted from 1
  double time = 0;         // as the header gives it
};

Frame last_frame(const PackingFile& file, const Kind& kind, LineReader lines) {
  TextRow row(file.path);
  Frame last{lines};
  while (lines.next()) {
    row.split(lines.line(), lines.number());
    if (row.size() == 0) continue;
    row.require_size(kind.header_size, kind.header);
    last = {lines, row.integer(0, "N"), last.number + 1, row.number(1, "t")};
    for (std::int64_t k = 0; k < last.count; ++k)
      if (!lines.next())
        throw InputError(
            fmt::format("{}:{}: the frame ends after {} particles; its header on line {} announces {}; the "
                        "file is cut off: remove that frame or write it again",
                        file.path, lines.number(), k, row.line(), last.count));
  }
  return last;
}

Packing read(const PackingFile& file) {
  LineReader beginning(file.content), lines = beginning;
  TextRow row(file.path);
  while (beginning.next()) {  // comments at the top
    row.split(beginning.line(), beginning.number());
    if (row.size() > 0 && row[0].front() != '#') break;
    lines = beginning;
  }
  const Kind& kind = *kind_of(row);
  auto [rows_of_frame, count, frames, time] = last_frame(file, kind, lines);
  SphereRows rows(file, {.names = kind.columns,
                         .place = fmt::format("{}:{}", file.path, rows_of_frame.number()),
                         .header = "the format",
                         .rules = {.flat = kind.flat}});
  for (std::int64_t k = 0; k < count; ++k) {
    rows_of_frame.next();
    row.split(rows_of_frame.line(), rows_of_frame.number());
    row.require_size(kind.columns.size(), kind.flat
                                              ? "x y, velocity, radius, angle, angular velocity, species"
                                              : "x y z, velocity, radius, angles, angular velocity, species");
    rows.add(row.cells(), row.line());
  }
  Packing packing = rows.finish();
  if (frames > 1) packing.frame = fmt::format("the last of {} frames, t = {}", frames, time);
  packing.notes.push_back("the box of the header is for drawing: whether it is periodic is not stated");
  return packing;
}

}  // namespace

PackingFormat mercury_format() {
  return {"MercuryDPM .data", recognises, read, true, true};
}

}  // namespace superstep
