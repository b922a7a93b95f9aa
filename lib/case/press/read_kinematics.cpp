#include "case/press/read_kinematics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "case/inputs/column_unit.hpp"
#include "core/error.hpp"
#include "core/text/csv.hpp"
#include "core/text/delimited.hpp"
#include "core/text/text_file.hpp"
#include "packing/units.hpp"

namespace superstep::dynamics {
namespace {

using Axes = std::array<const PackingAttribute*, 3>;

enum class Letters : char { same, any_case };

bool is_called(const std::string& column, std::string_view name, Letters letters) {
  const std::string_view bare = split_column_unit(column).name;
  return letters == Letters::same ? bare == name : lower_case(bare) == lower_case(name);
}

/// The column of that name, with a unit behind it or not; nullptr where there is none.
const PackingAttribute* find_column(const Packing& packing, const std::string& path, std::string_view name,
                                    Letters letters = Letters::any_case) {
  for (const auto& attribute : packing.attributes)
    if (is_called(attribute.name, name, letters)) return &attribute;
  for (const auto& column : packing.text_columns)
    if (is_called(column, name, letters))
      throw InputError(fmt::format(
          "{}: column '{}' holds text; a press takes it for numbers: correct them, or give it another name",
          path, column));
  return nullptr;
}

/// The velocity under one of the names that particle codes and their exports give it.
Axes velocity_columns(const Packing& packing, const std::string& path) {
  const auto axes_of = [&](const std::array<std::string, 3>& names) {
    return Axes{find_column(packing, path, names[0]), find_column(packing, path, names[1]),
                find_column(packing, path, names[2])};
  };
  const std::array<std::array<std::string, 3>, 4> plain = {{{"vx", "vy", "vz"},
                                                            {"v_x", "v_y", "v_z"},
                                                            {"velocity_x", "velocity_y", "velocity_z"},
                                                            {"velx", "vely", "velz"}}};
  for (const auto& names : plain)
    if (const Axes axes = axes_of(names); axes[0] || axes[1] || axes[2]) return axes;
  for (const char* vector : {"velocity", "velocities", "vel", "velo", "v", "linVelVec", "linear_velocity"})
    for (const char* pattern : {"{}:{}", "{}[{}]"}) {
      const auto axis = [&](int k) { return fmt::format(fmt::runtime(pattern), vector, k); };
      if (const Axes axes = axes_of({axis(0), axis(1), axis(2)}); axes[0]) return axes;
    }
  return {};
}

/// A lone T is a temperature, a t a time.
const PackingAttribute* temperature_column(const Packing& packing, const std::string& path) {
  for (const char* name : {"temperature", "temp", "f_temp", "f_temp[0]"})
    if (const auto* column = find_column(packing, path, name)) return column;
  return find_column(packing, path, "T", Letters::same);
}

bool is_flat(const Packing& packing) {
  return std::all_of(packing.centre.begin(), packing.centre.end(), [](const Vec3& at) { return at.z == 0; });
}

double value_at(const PackingAttribute& column, const Packing& packing, std::size_t k,
                const std::string& path) {
  const double value = column.value[k];
  if (!std::isfinite(value))
    throw InputError(
        fmt::format("{}: particle {} has no number in its column '{}'; give it one, or remove "
                    "the column",
                    path, packing.id[k], column.name));
  return value;
}

/// Metres per second of a unit of velocity in the file, where its columns do not say.
double velocity_unit(const Packing& packing, const std::string& path) {
  if (packing.unit_style.empty() || packing.unit_style == "lj") return packing.length_unit;
  if (const auto known = unit_style_velocity(packing.unit_style)) return *known;
  throw InputError(
      fmt::format("{}: its velocities are in units {}, whose unit of time is not sure; say what one of them "
                  "is in m/s: [dynamics.particles] velocity_unit",
                  path, packing.unit_style));
}

/// The same of one column that says it, as in "vx [mm/s]".
std::optional<double> stated_velocity_unit(const PackingAttribute& column, const std::string& path) {
  const std::string_view unit = split_column_unit(column.name).unit;
  if (unit.empty()) return std::nullopt;
  const auto metres = unit.ends_with("/s")
                          ? length_unit_of_column(lower_case(trimmed(unit.substr(0, unit.size() - 2))))
                          : std::nullopt;
  if (!metres)
    throw InputError(
        fmt::format("{}: column '{}' is in {}; valid units of velocity are m/s, cm/s, mm/s, um/s, nm/s", path,
                    column.name, unit));
  return metres;
}

[[noreturn]] void unknown(const CsvReader& rows, std::int64_t id) {
  throw InputError(fmt::format("{}: particle {} is not in the packing; remove the row", rows.where(), id));
}

}  // namespace

Kinematics read_kinematics(const std::string& path, const Packing& packing, std::optional<double> unit) {
  Kinematics out;
  const Axes axes = velocity_columns(packing, path);
  if (axes[0] || axes[1] || axes[2]) {
    std::array<double, 3> metres_per_second{};
    const char* names[] = {"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!axes[axis] && !(axis == 2 && is_flat(packing)))
        throw InputError(fmt::format("{}: has velocities, but none along {}; add the column, or remove them",
                                     path, names[axis]));
      const auto stated = axes[axis] ? stated_velocity_unit(*axes[axis], path) : std::nullopt;
      if (stated && unit && *stated != *unit)
        throw InputError(
            fmt::format("{}: column '{}' says another unit than velocity_unit = {} m/s; keep one", path,
                        axes[axis]->name, *unit));
      metres_per_second[axis] = stated ? *stated : unit ? *unit : velocity_unit(packing, path);
    }
    const auto along = [&](std::size_t axis, std::size_t k) {
      return axes[axis] ? metres_per_second[axis] * value_at(*axes[axis], packing, k, path) : 0.0;
    };
    for (std::size_t k = 0; k < packing.size(); ++k)
      out.velocity.push_back({along(0, k), along(1, k), along(2, k)});
  }
  const auto* column = temperature_column(packing, path);
  if (column == nullptr) return out;
  require_column_unit(column->name, "K", path);
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const double kelvin = value_at(*column, packing, k, path);
    if (!(kelvin >= 0))
      throw InputError(
          fmt::format("{}: particle {} has the temperature {} in its column '{}'; it must be "
                      ">= 0 K",
                      path, packing.id[k], kelvin, column->name));
    out.temperature.push_back(kelvin);
  }
  return out;
}

std::vector<Bond> read_bonds(const std::string& path, const Packing& packing) {
  enum Column : std::size_t { i, j, overlap, growth };
  CsvReader rows(path, {"i", "j", "overlap", "growth"});
  std::unordered_map<std::int64_t, std::size_t> places;
  for (std::size_t k = 0; k < packing.size(); ++k) places.emplace(packing.id[k], k);
  struct Row {
    Bond bond;
    std::size_t line;
  };
  std::vector<Row> read;
  while (rows.next()) {
    const auto a = places.find(rows.integer(i)), b = places.find(rows.integer(j));
    if (a == places.end()) unknown(rows, rows.integer(i));
    if (b == places.end()) unknown(rows, rows.integer(j));
    if (a == b) throw InputError(fmt::format("{}: a bond joins two particles; remove the row", rows.where()));
    if (!(rows.number(overlap) > 0 && rows.number(overlap) < 1))
      throw InputError(
          fmt::format("{}: overlap is {}; it must lie between 0 and 1", rows.where(), rows.number(overlap)));
    if (!(rows.number(growth) >= 0 && rows.number(growth) <= 1))
      throw InputError(
          fmt::format("{}: growth is {}; it must lie in [0, 1]", rows.where(), rows.number(growth)));
    const auto first = static_cast<std::int32_t>(std::min(a->second, b->second)),
               second = static_cast<std::int32_t>(std::max(a->second, b->second));
    read.push_back({{first, second, rows.number(overlap), rows.number(growth)}, rows.line()});
  }
  const auto pair = [](const Row& row) { return std::pair{row.bond.i, row.bond.j}; };
  std::sort(read.begin(), read.end(), [&](const Row& a, const Row& b) {
    return std::pair{pair(a), a.line} < std::pair{pair(b), b.line};
  });
  std::vector<Bond> bonds;
  for (std::size_t k = 0; k < read.size(); ++k) {
    if (k > 0 && pair(read[k]) == pair(read[k - 1]))
      throw InputError(fmt::format("{}:{}: the bond {}-{} has a row already, on line {}; keep one", path,
                                   read[k].line, packing.id[static_cast<std::size_t>(read[k].bond.i)],
                                   packing.id[static_cast<std::size_t>(read[k].bond.j)], read[k - 1].line));
    bonds.push_back(read[k].bond);
  }
  return bonds;
}

}  // namespace superstep::dynamics
