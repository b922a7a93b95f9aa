#include <fmt/format.h>

#include <cctype>

#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/packing_builder.hpp"
#include "packing/formats/text_row.hpp"

namespace superstep {
namespace {

constexpr std::string_view layout = "id type diameter density x y z, and three image flags if any";

/// `Atoms`, with the atom style behind '#' when the writer was kind enough to state it.
void check_style(const TextRow& heading) {
  if (heading.size() < 3) return;
  const auto style = heading[2];
  if (style != "sphere" && style != "granular")
    throw InputError(
        fmt::format("{}: atom style is {}; it must be sphere or granular, which know diameters; write the "
                    "data file with one of these",
                    heading.where(), quoted(style)));
}

void add_atom(PackingBuilder& builder, const TextRow& row) {
  constexpr std::size_t plain = 7, with_image_flags = 10;
  if (row.size() != with_image_flags) row.require_size(plain, layout);
  const Vec3 centre{row.number(4, "x"), row.number(5, "y"), row.number(6, "z")};
  builder.add(row.line(), row.integer(0, "id"), centre, 0.5 * row.number(2, "diameter"));
  builder.set_material(row[1]);
}

/// Headings are words. "nan" and "inf" are what a writer makes of a broken number: they begin a row.
bool is_heading(const TextRow& row) {
  std::string first(row[0]);
  for (auto& c : first) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (first == "nan" || first == "inf" || first == "infinity") return false;
  for (std::size_t k = 0; k < row.size(); ++k)
    if (!std::isalpha(static_cast<unsigned char>(row[k].front()))) return false;
  return true;
}

}  // namespace

Packing read_lammps_data(const PackingFile& file) {
  LineReader lines(file.text);
  TextRow row(file.path);
  PackingBuilder builder(file.path, file.unit);
  std::int64_t expected = 0;
  bool in_atoms = false;
  lines.next();  // the first line is a title, whatever it says
  while (lines.next()) {
    const std::string_view content = lines.line().substr(0, lines.line().find('#'));
    row.split(content, lines.number());
    if (row.size() == 0) continue;
    if (row.size() == 2 && row[1] == "atoms") expected = row.integer(0, "number of atoms");
    if (is_heading(row)) {
      in_atoms = row.size() == 1 && row[0] == "Atoms";
      row.split(lines.line(), lines.number());
      if (in_atoms) check_style(row);
    } else if (in_atoms) {
      add_atom(builder, row);
    }
  }
  if (expected != static_cast<std::int64_t>(builder.size()))
    throw InputError(
        fmt::format("{}:{}: section 'Atoms' has {} rows; the header announces {} atoms; the file is cut off "
                    "or edited: write it again",
                    file.path, lines.number(), builder.size(), expected));
  builder.drop_single_material();
  return builder.finish();
}

}  // namespace superstep
