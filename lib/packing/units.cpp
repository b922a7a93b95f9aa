#include "packing/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/error.hpp"
#include "core/text/text_file.hpp"

namespace superstep {
namespace {

constexpr std::array<std::pair<const char*, double>, 5> lengths = {
    {{"m", 1.0}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}, {"nm", 1e-9}}};

// Lengths and velocities of unit styles [m], [m/s]. Source: the LAMMPS command `units`; the electron style
// counts in Bohr radii (CODATA 2018), and what it calls an atomic unit of time is another one elsewhere.
constexpr std::array<std::pair<const char*, double>, 8> styles = {{{"lj", 0.0},
                                                                   {"real", 1e-10},
                                                                   {"metal", 1e-10},
                                                                   {"si", 1.0},
                                                                   {"cgs", 1e-2},
                                                                   {"electron", 5.29177210903e-11},
                                                                   {"micro", 1e-6},
                                                                   {"nano", 1e-9}}};
constexpr std::array<std::pair<const char*, double>, 6> velocities = {
    {{"real", 1e5}, {"metal", 1e2}, {"si", 1.0}, {"cgs", 1e-2}, {"micro", 1.0}, {"nano", 1.0}}};

template <class Table>
std::optional<double> look_up(const Table& table, const std::string& name) {
  for (const auto& [known, metres] : table)
    if (name == known) return metres;
  return std::nullopt;
}

}  // namespace

double length_unit(const std::string& name, const std::string& where) {
  if (const auto metres = look_up(lengths, name)) return *metres;
  throw InputError(
      fmt::format("{}: length unit is {}; valid are: m, cm, mm, um, nm", where, in_quotes(name)));
}

std::optional<double> length_unit_of_column(const std::string& name) {
  // The micro sign, the Greek letter, and the sign in Latin-1; alone they are the old name of a micrometre.
  for (const char* micrometre : {"\xC2\xB5m", "\xCE\xBCm", "\xB5m", "\xC2\xB5", "\xCE\xBC", "\xB5", "micron",
                                 "microns", "micrometer", "micrometre", "micrometers", "micrometres"})
    if (name == micrometre) return 1e-6;
  // The letter, large and small, the sign of the unit, and the letters in Latin-1.
  for (const std::string letter : {"\xC3\x85", "\xC3\xA5", "\xE2\x84\xAB", "\xC5", "\xE5"})
    if (name == letter || name == letter + "ngstrom" || name == letter + "ngstr\xC3\xB6m") return 1e-10;
  if (name == "angstrom" || name == "angstroms") return 1e-10;
  if (name == "meter" || name == "metre" || name == "meters" || name == "metres") return 1.0;
  return look_up(lengths, name);
}

std::string length_unit_name(double metres) {
  for (const auto& [name, size] : lengths)
    if (size == metres) return name;
  return fmt::format("{} m", metres);
}

std::optional<double> unit_style_length(const std::string& style) {
  return look_up(styles, style);
}

std::optional<double> unit_style_velocity(const std::string& style) {
  return look_up(velocities, style);
}

const std::vector<std::string>& unit_styles() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> out;
    for (const auto& [name, metres] : styles) out.emplace_back(name);
    return out;
  }();
  return names;
}

}  // namespace superstep
