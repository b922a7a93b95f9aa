#include "case/press/read_kinematics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "case/inputs/column_unit.hpp"
#include "core/error.hpp"
#include "core/text/csv.hpp"
#include "core/text/delimited.hpp"
#include "packing/units.hpp"

namespace superstep::dynamics {
namespace {

using Axes = std::array<const PackingAttribute*, 3>;

/// The velocity under one of the names that particle codes and their exports give it.
Axes velocity_columns(const Packing& packing) {
  constexpr std::array<std::array<const char*, 3>, 4> plain = {{{"vx", "vy", "vz"},
                                                                {"v_x", "v_y", "v_z"},
                                                                {"velocity_x", "velocity_y", "velocity_z"},
                                                                {"velx", "vely", "velz"}}};
  for (const auto& names : plain) {
    const Axes axes{find_attribute(packing, names[0]), find_attribute(packing, names[1]),
                    find_attribute(packing, names[2])};
    if (axes[0] || axes[1] || axes[2]) return axes;
  }
  for (const char* vector : {"velocity", "velocities", "vel", "velo", "v", "linVelVec", "linear_velocity"})
    if (find_attribute(packing, fmt::format("{}:0", vector))) {
      const auto axis = [&](int k) { return find_attribute(packing, fmt::format("{}:{}", vector, k)); };
      return {axis(0), axis(1), axis(2)};
    }
  return {};
}

const PackingAttribute* temperature_column(const Packing& packing) {
  for (const char* name : {"temperature", "Temp", "T", "f_Temp", "f_Temp[0]"}) {
    if (const auto* column = find_attribute(packing, name)) return column;
    for (const auto& column : packing.attributes)
      if (lower_case(split_column_unit(column.name).name) == lower_case(name)) return &column;
  }
  return nullptr;
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

/// Metres per second of a unit of velocity in the file.
double velocity_unit(const Packing& packing, const std::string& path) {
  if (packing.unit_style.empty() || packing.unit_style == "lj") return packing.length_unit;
  if (const auto known = unit_style_velocity(packing.unit_style)) return *known;
  throw InputError(
      fmt::format("{}: its velocities are in units {}, whose unit of time is not sure; say what one of them "
                  "is in m/s: [dynamics.particles] velocity_unit",
                  path, packing.unit_style));
}

[[noreturn]] void unknown(const CsvReader& rows, std::int64_t id) {
  throw InputError(fmt::format("{}: particle {} is not in the packing; remove the row", rows.where(), id));
}

}  // namespace

Kinematics read_kinematics(const std::string& path, const Packing& packing, std::optional<double> unit) {
  Kinematics out;
  const Axes axes = velocity_columns(packing);
  if (axes[0] || axes[1] || axes[2]) {
    const double metres_per_second = unit ? *unit : velocity_unit(packing, path);
    const char* names[] = {"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!axes[axis] && !(axis == 2 && is_flat(packing)))
        throw InputError(fmt::format("{}: has velocities, but none along {}; add the column, or remove them",
                                     path, names[axis]));
    const auto along = [&](std::size_t axis, std::size_t k) {
      return axes[axis] ? value_at(*axes[axis], packing, k, path) : 0.0;
    };
    for (std::size_t k = 0; k < packing.size(); ++k)
      out.velocity.push_back(metres_per_second * Vec3{along(0, k), along(1, k), along(2, k)});
  }
  if (const auto* column = temperature_column(packing)) {
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
  }
  return out;
}

std::vector<Bond> read_bonds(const std::string& path, const Packing& packing) {
  enum Column : std::size_t { i, j, overlap, growth };
  CsvReader rows(path, {"i", "j", "overlap", "growth"});
  std::unordered_map<std::int64_t, std::size_t> places;
  for (std::size_t k = 0; k < packing.size(); ++k) places.emplace(packing.id[k], k);
  std::vector<Bond> bonds;
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
    bonds.push_back({first, second, rows.number(overlap), rows.number(growth)});
  }
  const auto key = [](const Bond& bond) { return std::pair{bond.i, bond.j}; };
  std::sort(bonds.begin(), bonds.end(), [&](const Bond& a, const Bond& b) { return key(a) < key(b); });
  for (std::size_t k = 1; k < bonds.size(); ++k)
    if (key(bonds[k]) == key(bonds[k - 1]))
      throw InputError(fmt::format("{}: the bond {}-{} has two rows; keep one", path,
                                   packing.id[static_cast<std::size_t>(bonds[k].i)],
                                   packing.id[static_cast<std::size_t>(bonds[k].j)]));
  return bonds;
}

}  // namespace superstep::dynamics
