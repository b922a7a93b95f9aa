#include "packing/formats/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "core/error.hpp"
#include "core/text/bracketed_unit.hpp"
#include "core/text/delimited.hpp"
#include "core/text/suggest.hpp"
#include "packing/units.hpp"

namespace superstep {
namespace {

using Names = std::vector<std::string>;

/// A name with everything taken off that people write differently, and the unit that stood behind it.
struct PlainName {
  std::string name;
  std::optional<double> unit;
};

std::string letters_and_digits(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)))
      out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

/// "Radius [mm]", "x (um)", "x_mm": the part before the unit, and the unit.
PlainName plain_name(std::string_view written) {
  if (const auto bar = written.rfind('|'); bar != std::string_view::npos) written.remove_prefix(bar + 1);
  written = trimmed(written);
  auto [rest, unit] = split_bracketed_unit(written);
  if (const std::size_t cut = written.find_last_of("_/ ");
      rest == written && cut != std::string_view::npos && cut > 0) {
    unit = written.substr(cut + 1);
    rest = written.substr(0, cut);
  }
  if (const auto metres = unit.empty() ? std::nullopt : length_unit_of_column(lower_case(unit)))
    return {letters_and_digits(rest), metres};
  return {letters_and_digits(written), std::nullopt};
}

/// The names of a coordinate along an axis ('x' with number 0, ...), the more usual ones first.
Names coordinate_names(char axis, char number) {
  Names out;
  for (const char* pattern :
       {"*", "*c", "*coord", "*coordinate", "*pos", "pos*", "position*", "*position", "coord*", "coordinate*",
        "centre*", "center*", "*centre", "*center", "centroid*"}) {
    std::string name = pattern;
    name.replace(name.find('*'), 1, 1, axis);
    out.push_back(name);
  }
  for (const char* word : {"points", "coords", "coordinates", "position", "positions", "pos", "centre",
                           "center", "porecoords", "centroid"})
    out.push_back(std::string(word) + number);
  return out;
}

Names lammps_names(char axis, const char* ending) {
  return {std::string(1, axis) + ending};
}

const Names& id_names() {
  static const Names names = {"id", "ids", "particleid", "atomid", "bodyid", "sphereid"};
  return names;
}
const Names& radius_names() {
  static const Names names = {"radius", "r", "rad", "radii", "particleradius", "sphereradius"};
  return names;
}
const Names& diameter_names() {
  static const Names names = {"diameter",         "d",           "dia", "diam", "diameters",
                              "particlediameter", "porediameter"};
  return names;
}
const Names& material_names() {
  static const Names names = {"material",     "materialname", "mat",      "matid",   "materialid",
                              "materialtype", "type",         "atomtype", "species", "group"};
  return names;
}

class Finder {
 public:
  Finder(std::span<const std::string> names, std::string place, std::string header)
      : written_(names), place_(std::move(place)), header_(std::move(header)) {
    for (const auto& name : names) plain_.push_back(plain_name(name));
    for (std::size_t k = 0; k < names.size(); ++k)
      for (std::size_t j = 0; j < k; ++j)
        if (!names[k].empty() && names[j] == names[k])
          throw InputError(
              fmt::format("{}: column '{}' stands twice in {}; keep one", place_, names[k], header_));
  }

  [[nodiscard]] std::size_t find(const Names& candidates) const {
    for (const auto& candidate : candidates)
      for (std::size_t k = 0; k < plain_.size(); ++k)
        if (plain_[k].name == candidate) return k;
    return SphereColumns::none;
  }
  [[nodiscard]] std::optional<double> unit(std::size_t column) const {
    return column == SphereColumns::none ? std::nullopt : plain_[column].unit;
  }
  [[noreturn]] void missing(const std::string& name) const {
    const std::string wanted[] = {name};
    std::string hint;
    for (const auto& other : written_)
      if (hint.empty() && other.size() > 2 && !nearest_by_spelling(lower_case(other), wanted).empty())
        hint = fmt::format("; is '{}' meant?", other);
    throw InputError(
        fmt::format("{}: column '{}' is missing from {}; a packing needs x y z and radius or diameter "
                    "(and id, type or material if there are several){}; add it",
                    place_, name, header_, hint));
  }
  [[nodiscard]] const std::string& place() const noexcept { return place_; }

 private:
  std::span<const std::string> written_;
  std::vector<PlainName> plain_;
  std::string place_, header_;
};

void find_positions(const Finder& finder, bool lammps, bool flat, SphereColumns& columns) {
  using Positions = SphereColumns::Positions;
  const std::array<std::size_t*, 3> places = {&columns.x, &columns.y, &columns.z};
  const auto fill = [&](const auto& names_of) {
    bool all = true;
    for (std::size_t k = 0; k < (flat ? 2U : 3U); ++k) {
      *places[k] = finder.find(names_of(k));
      all = all && *places[k] != SphereColumns::none;
    }
    return all;
  };
  const auto plain = [](std::size_t k) { return coordinate_names("xyz"[k], "012"[k]); };
  if (fill(plain)) return;
  if (lammps)
    for (const auto& [ending, kind] : {std::pair{"u", Positions::unwrapped},
                                       {"s", Positions::scaled},
                                       {"su", Positions::scaled_unwrapped}})
      if (fill([ending = ending](std::size_t k) { return lammps_names("xyz"[k], ending); })) {
        columns.positions = kind;
        return;
      }
  (void)fill(plain);
  for (std::size_t k = 0; k < (flat ? 2U : 3U); ++k)
    if (*places[k] == SphereColumns::none) finder.missing(std::string(1, "xyz"[k]));
}

/// Units behind the names: for all lengths or for none, and one for positions.
void find_units(const Finder& finder, bool flat, SphereColumns& columns) {
  const auto size = columns.radius != SphereColumns::none ? columns.radius : columns.diameter;
  const auto x = finder.unit(columns.x), y = finder.unit(columns.y), z = flat ? x : finder.unit(columns.z),
             r = finder.unit(size);
  if (!x && !y && !z && !r) return;
  if (!x || x != y || x != z || !r)
    throw InputError(
        fmt::format("{}: the columns of lengths state units for some of them only, or different ones for "
                    "x, y and z; state one for all, or none and give length_unit",
                    finder.place()));
  columns.unit = x;
  columns.size_factor = *r / *x;
}

}  // namespace

SphereColumns find_sphere_columns(std::span<const std::string> names, bool lammps, bool flat,
                                  const std::string& place, const std::string& header) {
  const Finder finder(names, place, header);
  SphereColumns columns;
  find_positions(finder, lammps, flat, columns);
  columns.radius = finder.find(radius_names());
  columns.diameter = finder.find(diameter_names());
  if (columns.radius == SphereColumns::none && columns.diameter == SphereColumns::none)
    finder.missing("radius");
  columns.id = finder.find(id_names());
  columns.material = finder.find(material_names());
  columns.material_is_number =
      columns.material != SphereColumns::none && lower_case(names[columns.material]) != "material";
  find_units(finder, flat, columns);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::string name = lower_case(names[k]);
    if (name.empty() || name.starts_with("unnamed: "))
      columns.row_numbers.push_back(k);
    else if (k != columns.id && k != columns.x && k != columns.y && k != columns.z && k != columns.radius &&
             k != columns.diameter && k != columns.material)
      columns.attributes.push_back(k);
  }
  return columns;
}

bool names_a_position(std::span<const std::string> names) {
  const Finder finder(names, {}, {});
  for (std::size_t k = 0; k < 3; ++k)
    if (finder.find(coordinate_names("xyz"[k], "012"[k])) == SphereColumns::none) return false;
  return true;
}

std::string likely_misspelling(const std::string& name) {
  static const std::vector<std::string> words = {"material"};
  const std::string plain = letters_and_digits(name);
  return plain.size() < 6 || plain == words[0] ? std::string{} : nearest_by_spelling(plain, words);
}

}  // namespace superstep
