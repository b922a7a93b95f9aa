#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/packing_builder.hpp"
#include "packing/formats/text_row.hpp"

namespace superstep {
namespace {

constexpr std::size_t header_size = 8, row_size = 14, radius_column = 6, species_column = 13;

struct Frame {
  LineReader rows;  // before the first of them
  std::int64_t count = 0;
  std::size_t number = 0;  // counted from 1
  double time = 0;         // as the header gives it
};

Frame last_frame(const PackingFile& file) {
  LineReader lines(file.text);
  TextRow row(file.path);
  Frame last{lines};
  while (lines.next()) {
    row.split(lines.line(), lines.number());
    if (row.size() == 0) continue;
    row.require_size(header_size, "N t xmin ymin zmin xmax ymax zmax, the header of a frame");
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

}  // namespace

Packing read_mercury(const PackingFile& file) {
  auto [lines, count, frames, time] = last_frame(file);
  TextRow row(file.path);
  PackingBuilder builder(file.path, file.unit);
  for (std::int64_t k = 0; k < count; ++k) {
    lines.next();
    row.split(lines.line(), lines.number());
    row.require_size(row_size, "x y z, velocity, radius, angles, angular velocity, species");
    const Vec3 centre{row.number(0, "x"), row.number(1, "y"), row.number(2, "z")};
    builder.add(row.line(), k, centre, row.number(radius_column, "radius"));
    builder.set_material(row[species_column]);
  }
  builder.drop_single_material();
  Packing packing = builder.finish();
  if (frames > 1) packing.frame = fmt::format("the last of {} frames, t = {}", frames, time);
  return packing;
}

}  // namespace superstep
