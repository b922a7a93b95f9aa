/// Extended XYZ with radii, as ASE and OVITO write it.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "core/error.hpp"
#include "core/text/delimited.hpp"
#include "core/text/number.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/recognise.hpp"
#include "packing/formats/sphere_rows.hpp"
#include "packing/formats/text_row.hpp"

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
  if (lower_case(lines.line()).find("properties=") != std::string::npos) return true;
  if (!lines.next()) return false;
  row.split(lines.line(), 3);
  return row.size() >= 4 && !parse_number(row[0]);
}

/// `key=value` and `key="several values"` of the comment line, keys in lower case.
std::map<std::string, std::string> pairs_of(std::string_view comment) {
  std::map<std::string, std::string> out;
  while (!comment.empty()) {
    const std::size_t equals = comment.find('=');
    if (equals == std::string_view::npos) break;
    std::string_view key = trimmed(comment.substr(0, equals));
    if (const auto blank = key.find_last_of(" \t"); blank != std::string_view::npos)
      key.remove_prefix(blank + 1);
    comment = comment.substr(equals + 1);
    const bool in_quotes = !comment.empty() && comment.front() == '"';
    if (in_quotes) comment.remove_prefix(1);
    const std::size_t end = in_quotes ? comment.find('"') : comment.find_first_of(" \t");
    out.emplace(lower_case(key), std::string(comment.substr(0, end)));
    comment = end == std::string_view::npos ? std::string_view{} : comment.substr(end + (in_quotes ? 1 : 0));
  }
  return out;
}

/// Names of the columns from `Properties=species:S:1:pos:R:3:radius:R:1`.
std::vector<std::string> property_names(const std::string& properties, const std::string& place) {
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

std::optional<Cell> cell_of(const std::map<std::string, std::string>& pairs, const std::string& place) {
  const auto lattice = pairs.find("lattice");
  if (lattice == pairs.end()) return std::nullopt;
  TextRow row(place);
  row.split(lattice->second, 2);
  const auto vector = [&](std::size_t k) {
    return Vec3{row.number(k, "Lattice"), row.number(k + 1, "Lattice"), row.number(k + 2, "Lattice")};
  };
  row.require_size(9, "the three edges of the Lattice");
  Cell cell{.origin = {}, .edge = {vector(0), vector(3), vector(6)}, .periodic = {true, true, true}};
  if (const auto origin = pairs.find("origin"); origin != pairs.end()) {
    row.split(origin->second, 2);
    row.require_size(3, "the corner of the Lattice");
    cell.origin = vector(0);
  }
  if (const auto pbc = pairs.find("pbc"); pbc != pairs.end()) {
    row.split(pbc->second, 2);
    row.require_size(3, "T or F along each edge of the Lattice");
    for (std::size_t k = 0; k < 3; ++k) cell.periodic[k] = row[k] == "T" || row[k] == "1" || row[k] == "True";
  }
  return cell;
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
  const auto pairs = pairs_of(frame.lines.line());
  const auto properties = pairs.find("properties");
  SphereLayout layout{.place = place, .header = "Properties", .cell = cell_of(pairs, file.path)};
  if (!file.options.columns.empty()) {
    layout.names = file.options.columns;
    layout.header = "the declared columns";
  } else if (properties == pairs.end()) {
    throw InputError(
        fmt::format("{}: this is plain XYZ, which has no radii: write extended XYZ, whose second line holds "
                    "Properties=species:S:1:pos:R:3:radius:R:1, or declare [packing] columns if a column "
                    "of radii is there",
                    place));
  } else {
    layout.names = property_names(properties->second, place);
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
  return {"extended XYZ", recognises, read};
}

}  // namespace superstep
