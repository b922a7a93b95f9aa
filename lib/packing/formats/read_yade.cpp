#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/packing_builder.hpp"
#include "packing/formats/text_row.hpp"

namespace superstep {

Packing read_yade(const PackingFile& file) {
  LineReader lines(file.text);
  TextRow row(file.path);
  PackingBuilder builder(file.path, file.unit);
  std::string format;
  while (lines.next()) {
    row.split(lines.line(), lines.number());
    if (row.size() == 0) continue;
    if (row[0] == "#format") {
      if (builder.size() > 0)
        throw InputError(
            fmt::format("{}: a line #format follows particles; it must stand above them, once: two exports "
                        "in one file are two packings",
                        row.where()));
      format = row.size() == 2 ? std::string(row[1]) : std::string{};
      if (format != "x_y_z_r" && format != "x_y_z_r_matId")
        throw InputError(
            fmt::format("{}: format is {}; it must be x_y_z_r or x_y_z_r_matId; export the packing as one "
                        "of these",
                        row.where(), quoted(trimmed(lines.line()))));
      continue;
    }
    if (row[0].front() == '#') continue;
    const bool has_material = format == "x_y_z_r_matId";
    row.require_size(has_material ? 5 : 4, "those of the line #format");
    const Vec3 centre{row.number(0, "x"), row.number(1, "y"), row.number(2, "z")};
    builder.add(row.line(), static_cast<std::int64_t>(builder.size()), centre, row.number(3, "r"));
    if (has_material) builder.set_material(row[4]);
  }
  builder.drop_single_material();
  return builder.finish();
}

}  // namespace superstep
