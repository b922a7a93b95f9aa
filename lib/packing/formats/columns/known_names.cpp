#include "packing/formats/columns/known_names.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "core/text/bracketed_unit.hpp"
#include "core/text/delimited.hpp"
#include "packing/units.hpp"

namespace superstep {
namespace {

/// Letters beyond ASCII are kept as they are: a name that holds one is another name.
std::string letters_and_digits(std::string_view text) {
  constexpr std::string_view hard_blank = "\xC2\xA0";
  std::string out;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto c = static_cast<unsigned char>(text[k]);
    if (text.substr(k).starts_with(hard_blank))
      ++k;
    else if (c >= 0x80 || std::isalnum(c))
      out += static_cast<char>(std::tolower(c));
  }
  return out;
}

/// Without what tables of OpenPNM put before names, as in "net|pore.all".
std::string_view last_part(std::string_view written) {
  if (const auto bar = written.rfind('|'); bar != std::string_view::npos) written.remove_prefix(bar + 1);
  return trimmed(written);
}

std::vector<CoordinateNames> all_coordinate_names() {
  std::vector<CoordinateNames> out;
  for (const char* pattern :
       {"*", "*c", "*coord", "*coordinate", "*pos", "pos*", "position*", "*position", "coord*", "coordinate*",
        "centre*", "center*", "*centre", "*center", "centroid*"}) {
    CoordinateNames names;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      names[axis] = pattern;
      names[axis].replace(names[axis].find('*'), 1, 1, "xyz"[axis]);
    }
    out.push_back(names);
  }
  for (const std::string word : {"points", "coords", "coordinates", "position", "positions", "pos", "centre",
                                 "center", "porecoords", "centroid"})
    out.push_back({word + "0", word + "1", word + "2"});
  return out;
}

}  // namespace

PlainName plain_name(std::string_view written) {
  written = last_part(written);
  if (written == "#") return {"#", std::nullopt, {}};  // of a column of numbers
  auto [rest, unit] = split_bracketed_unit(written);
  const bool in_brackets = rest != written;
  if (const std::size_t cut = written.find_last_of("_/ ");
      !in_brackets && cut != std::string_view::npos && cut > 0) {
    unit = written.substr(cut + 1);
    rest = written.substr(0, cut);
  }
  if (const auto metres = unit.empty() ? std::nullopt : length_unit_of_column(lower_case(unit)))
    return {letters_and_digits(rest), metres, {}};
  const bool is_index = unit.find_first_not_of("0123456789") == std::string_view::npos;  // coords[0]
  return {letters_and_digits(written), std::nullopt,
          in_brackets && !is_index ? std::string(unit) : std::string{}};
}

std::string name_without_unit(std::string_view written) {
  const PlainName plain = plain_name(written);
  return plain.unknown_unit.empty() ? plain.name
                                    : letters_and_digits(split_bracketed_unit(last_part(written)).name);
}

const std::vector<CoordinateNames>& coordinate_names() {
  static const std::vector<CoordinateNames> names = all_coordinate_names();
  return names;
}
const std::vector<std::string>& id_names() {
  static const std::vector<std::string> names = {"id",     "ids",      "particleid", "atomid",
                                                 "bodyid", "sphereid", "#"};
  return names;
}
const std::vector<std::string>& radius_names() {
  static const std::vector<std::string> names = {"radius",         "r",           "rad", "radii",
                                                 "particleradius", "sphereradius"};
  return names;
}
const std::vector<std::string>& diameter_names() {
  static const std::vector<std::string> names = {
      "diameter", "d", "dia", "diam", "diameters", "particlediameter", "porediameter"};
  return names;
}
const std::vector<std::string>& material_names() {
  static const std::vector<std::string> names = {"material",   "materialname", "mat",  "matid",
                                                 "materialid", "materialtype", "type", "atomtype",
                                                 "species",    "group"};
  return names;
}

bool names_a_time(std::string_view written) {
  static const std::vector<std::string> names = {"time", "timestep", "timevalue", "frame", "step"};
  return std::find(names.begin(), names.end(), name_without_unit(written)) != names.end();
}

std::string usual_meaning(std::string_view written) {
  const std::string name = plain_name(written).name;
  for (const auto& names : coordinate_names())
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (names[axis] == name) return {"xyz"[axis]};
  for (const auto& [meaning, names] : {std::pair{"radius", &radius_names()},
                                       {"diameter", &diameter_names()},
                                       {"id", &id_names()},
                                       {"material", &material_names()}})
    if (std::find(names->begin(), names->end(), name) != names->end()) return meaning;
  return {};
}

}  // namespace superstep
