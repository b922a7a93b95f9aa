/// Extended XYZ with radii, as ASE and OVITO write it.

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "core/text/delimited.hpp"
#include "core/text/number.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/columns/declared.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/recognise.hpp"
#include "packing/formats/sphere_rows.hpp"
#include "packing/formats/text_row.hpp"
#include "packing/formats/xyz/xyz_comment.hpp"

namespace superstep {
namespace {

/// A lone count, a comment, and rows that begin with a word or hold what `Properties=` names.
bool recognises(const PackingFile& file) {
  if (!file.is_text) return false;
  LineReader lines(file.content);
  TextRow row({});
  if (!lines.next()) return false;
  row.split(lines.line(), 1);
  if (row.size() != 1 || !parse_integer(row[0]) || !lines.next()) return false;
  if (xyz_pairs(lines.line()).contains("properties")) return true;
  if (!lines.next()) return false;
  row.split(lines.line(), 3);
  return row.size() >= 4 && !parse_number(row[0]);
}

/// Where the property `pos` has its three columns: it is the position by the format itself.
std::optional<std::size_t> place_of_pos(const std::vector<std::string>& names) {
  for (std::size_t k = 0; k + 2 < names.size(); ++k)
    if (lower_case(names[k]) == "pos:0" && lower_case(names[k + 2]) == "pos:2") return k;
  return std::nullopt;
}

struct Frame {
  LineReader lines{""};  ///< before its comment line
  std::int64_t count = 0;
  std::size_t number = 0;  ///< counted from 1
};

Frame last_frame(const PackingFile& file) {
  LineReader lines(file.content);
  TextRow row(file.path);
  Frame last;
  while (lines.next()) {
    row.split(lines.line(), lines.number());
    if (row.size() == 0) continue;
    row.require_size(1, "the number of particles, with which a frame begins");
    last = {lines, row.integer(0, "number of particles"), last.number + 1};
    for (std::int64_t k = 0; k <= last.count; ++k)
      if (!lines.next())
        throw InputError(
            fmt::format("{}:{}: the frame ends after {} particles; line {} announces {}; the file is cut "
                        "off: remove that frame or write it again",
                        file.path, lines.number(), std::max<std::int64_t>(k - 1, 0), row.line(), last.count));
  }
  return last;
}

Packing read(const PackingFile& file) {
  Frame frame = last_frame(file);
  frame.lines.next();
  const std::string place = fmt::format("{}:{}", file.path, frame.lines.number());
  const XyzPairs pairs = xyz_pairs(frame.lines.line());
  const auto properties = pairs.find("properties");
  SphereLayout layout{
      .place = place, .header = "Properties", .cell = xyz_cell(pairs, file.path, frame.lines.number())};
  if (!file.options.columns.empty()) {
    const auto own = properties == pairs.end() ? std::vector<std::string>{}
                                               : xyz_property_names(properties->second, place);
    if (own.size() == file.options.columns.size()) require_same_meaning(file, own);
    layout.names = file.options.columns;
    layout.header = "the declared columns";
  } else if (properties == pairs.end()) {
    throw InputError(
        fmt::format("{}: this is plain XYZ, which has no radii: write extended XYZ, whose second line holds "
                    "Properties=species:S:1:pos:R:3:radius:R:1, or declare [packing] columns if a column "
                    "of radii is there",
                    place));
  } else {
    layout.names = xyz_property_names(properties->second, place);
    layout.rules.positions_at = place_of_pos(layout.names);
  }
  const std::size_t width = layout.names.size();
  const bool assumed = layout.cell && !pairs.contains("pbc");
  SphereRows rows(file, std::move(layout));
  TextRow row(file.path);
  for (std::int64_t k = 0; k < frame.count; ++k) {
    frame.lines.next();
    row.split(frame.lines.line(), frame.lines.number());
    row.require_size(width, "those of Properties");
    rows.add(row.cells(), row.line());
  }
  Packing packing = rows.finish();
  if (frame.number > 1) packing.frame = fmt::format("the last of {} frames", frame.number);
  if (assumed) packing.notes.push_back("a Lattice without pbc is periodic along its three edges");
  return packing;
}

}  // namespace

PackingFormat xyz_format() {
  return {"extended XYZ", recognises, read, false, true};
}

}  // namespace superstep
