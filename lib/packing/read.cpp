#include "packing/read.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/text/cut_off.hpp"
#include "core/text/decoding/encoding.hpp"
#include "core/text/suggest.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/inside_cell.hpp"
#include "packing/formats/stated.hpp"
#include "packing/parts/layers.hpp"

namespace superstep {
namespace {

/// Every format, in the order in which a file is held against them.
const std::vector<PackingFormat>& formats() {
  static const std::vector<PackingFormat> list = {
      doubles_format(),     vtk_legacy_format(), vtk_xml_format(), yade_format(),  lammps_data_format(),
      lammps_dump_format(), mercury_format(),    xyz_format(),     table_format(),
  };
  return list;
}

std::string format_names() {
  std::vector<std::string> names;
  for (const auto& format : formats()) names.push_back(format.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

[[noreturn]] void refuse(const PackingFile& file) {
  if (!file.is_text)
    throw InputError(
        fmt::format("{}: holds NUL bytes, so it is binary, and begins none of the binary formats: VTK, or "
                    "rows of four doubles, to be declared by [packing] format = \"xyzd\" or \"xyzr\"",
                    file.path));
  LineReader lines(file.content);
  while (lines.next() && (trimmed(lines.line()).empty() || trimmed(lines.line()).front() == '#')) {
  }
  throw InputError(
      fmt::format("{}:{}: line {} begins none of the known formats: {}; write the packing as one of these",
                  file.path, lines.number(), in_quotes(lines.line()), format_names()));
}

const PackingFormat& choose_format(const PackingFile& file) {
  for (const auto& format : formats())
    if (format.recognises(file)) return format;
  refuse(file);
}

std::string read_content(const std::string& path, const PackingOptions& options) {
  std::string bytes = read_bytes(path);
  return holds_doubles(path, bytes, options) ? bytes : to_utf8(std::move(bytes));
}

PackingFile open(const std::string& path, std::string_view content, const PackingOptions& options) {
  require_content(content, path);
  PackingFile file{.path = path,
                   .content = content,
                   .options = options,
                   .stated = std::nullopt,
                   .is_text = content.find('\0') == std::string_view::npos};
  if (file.is_text) file.stated = stated_length_unit(path, content);
  return file;
}

}  // namespace

double choose_unit(const PackingFile& file, const std::optional<StatedUnit>& by_format, Packing& packing) {
  std::optional<StatedUnit> claim;
  const std::string place = file.options.place.empty() ? file.path : file.options.place;
  const auto take = [&](const std::optional<StatedUnit>& other, const std::string& who, const char* way_out) {
    if (!other || other->metres == 0) return;
    constexpr double rounding = 1e-12;
    if (claim && std::abs(claim->metres - other->metres) > rounding * claim->metres)
      throw InputError(fmt::format("{}: the unit of length is {}, and {} {}; {}", place, claim->words, who,
                                   other->words, way_out));
    if (!claim) claim = other;
  };
  if (file.options.length_unit)
    claim = StatedUnit{*file.options.length_unit, length_unit_name(*file.options.length_unit)};
  if (file.options.units != "auto") {
    const auto metres = unit_style_length(file.options.units);
    if (!metres)
      throw InputError(fmt::format("{}: units is {}; it must be auto or a unit style{}", place,
                                   in_quotes(file.options.units),
                                   suggestion(file.options.units, unit_styles())));
    packing.unit_style = file.options.units;
    take(StatedUnit{*metres, fmt::format("units {}", file.options.units)}, "beside it stands",
         "leave one of the two out");
  } else if (by_format) {
    packing.unit_style = by_format->style;
  }
  for (const auto& stated : {file.stated, by_format})
    take(stated, file.path + " states that its lengths are in", "give that unit, or leave this key out");
  const bool dimensionless = (by_format && by_format->metres == 0) || file.options.units == "lj";
  if (claim) {
    packing.notes.push_back(fmt::format("lengths are in {}", claim->words));
  } else if (dimensionless) {
    packing.warnings.push_back(
        fmt::format("{}: its lengths have no dimension (units lj) and are taken as metres; give "
                    "length_unit",
                    file.path));
  } else {
    packing.notes.push_back("the file states no unit of length: m");
    if (const auto mentioned = mentioned_length_unit(file.is_text ? file.content : std::string_view{}))
      packing.warnings.push_back(fmt::format(
          "{}:{}: a comment mentions {}, and lengths are taken as metres, since the file does not state "
          "their unit: write # length_unit = \"mm\" or the like, or give length_unit",
          file.path, mentioned->line, in_quotes(mentioned->text)));
  }
  return claim ? claim->metres : 1.0;
}

void apply_box(const PackingOptions& options, const std::string& path, Packing& packing) {
  const std::string place = options.place.empty() ? path : options.place;
  if (options.box && packing.cell)
    throw InputError(fmt::format("{}: {} states its box; leave out [packing] box", place, path));
  if (options.box) {
    packing.cell = options.box;
    packing.cell->origin = packing.length_unit * packing.cell->origin;
    for (auto& edge : packing.cell->edge) edge = packing.length_unit * edge;
  }
  if (options.periodic != "auto") {
    const auto edges = periodic_edges(options.periodic, place);
    if (!packing.cell && (edges[0] || edges[1] || edges[2]))
      throw InputError(
          fmt::format("{}: periodic is \"{}\", and {} states no box; give [packing] box = {{ min, max }}",
                      place, options.periodic, path));
    if (packing.cell) {
      const std::string stated = packing.cell->periodic_axes();
      const auto before = std::exchange(packing.cell->periodic, edges);
      const bool is_cut = (before[0] && !edges[0]) || (before[1] && !edges[1]) || (before[2] && !edges[2]);
      if (const std::string now = packing.cell->periodic_axes(); is_cut)
        packing.warnings.push_back(fmt::format(
            "{}: the file says that its box is periodic along {}, {} sides are left out", path, stated,
            options.has_walls ? "and a press has walls instead: contacts across these"
                              : fmt::format("the case says {}: contacts across the other", now)));
    }
  }
  if (options.box) require_inside_cell(packing, false, path, {});
  if (!packing.cell || !packing.cell->is_periodic()) return;
  if (!(packing.cell->volume() > 0))
    throw InputError(
        fmt::format("{}: the box is periodic along {} and has no volume; mend its bounds, or say periodic = "
                    "\"none\"",
                    path, packing.cell->periodic_axes()));
  packing.notes.push_back(
      fmt::format("periodic along {}: contacts reach across these sides", packing.cell->periodic_axes()));
  for (auto& centre : packing.centre) centre = packing.cell->wrapped(centre);
}

Packing read_packing(const std::string& path, const PackingOptions& options) {
  const std::string content = read_content(path, options);
  const PackingFile file = open(path, content, options);
  const PackingFormat& format = choose_format(file);
  if (!options.atom_style.empty() && format.name != lammps_data_format().name)
    throw InputError(fmt::format("{}: atom_style is for LAMMPS/LIGGGHTS data, and {} is {}; leave it out",
                                 options.place.empty() ? path : options.place, path, format.name));
  if (!options.columns.empty() && format.names_columns)
    throw InputError(fmt::format(
        "{}: columns is for files that do not name theirs, and {} is {}, which does; leave it out",
        options.place.empty() ? path : options.place, path, format.name));
  Packing packing = format.read(file);
  packing.format = format.name;
  packing.place = path;
  if (auto unfinished = unfinished_line(path, content);
      format.ends_lines && file.is_text && !unfinished.empty())
    packing.warnings.push_back(std::move(unfinished));
  apply_box(options, path, packing);
  if (options.in_layers) stand_in_layers(packing);
  return packing;
}

bool is_table(const std::string& path, std::string_view text, const PackingOptions& options) {
  return !holds_doubles(path, text, options) &&
         &choose_format(open(path, text, options)) == &formats().back();
}

Packing read_table(const std::string& path, std::string_view text, const PackingOptions& options) {
  Packing packing = formats().back().read(open(path, text, options));
  packing.format = formats().back().name;
  packing.place = path;
  return packing;
}

Packing read_packing(const std::string& path, double unit) {
  PackingOptions options;
  options.length_unit = unit;
  return read_packing(path, options);
}

std::string recognised_format(const std::string& path) {
  const std::string content = read_content(path, {});
  const PackingFile file = open(path, content, {});
  for (std::size_t k = 0; k + 1 < formats().size(); ++k)
    if (formats()[k].recognises(file)) return formats()[k].name;
  return {};
}

bool reads_as_packing(const std::string& path) {
  try {
    (void)read_packing(path);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace superstep
