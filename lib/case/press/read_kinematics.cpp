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

using Columns = std::vector<const PackingAttribute*>;

/// The columns of that name, with a unit behind it or not.
Columns find_columns(const Packing& packing, const std::string& path, std::string_view name,
                     Letters letters = Letters::any_case) {
  Columns found;
  for (const auto& attribute : packing.attributes)
    if (is_called(attribute.name, name, letters)) found.push_back(&attribute);
  for (const auto& column : packing.text_columns)
    if (found.empty() && is_called(column, name, letters))
      throw InputError(fmt::format(
          "{}: column '{}' holds text; a press takes it for numbers: correct them, or give it another name",
          path, column));
  return found;
}

/// Velocities under the names that particle codes and their exports give them, the first of which counts.
std::vector<Axes> velocity_columns(const Packing& packing, const std::string& path) {
  std::vector<Axes> found;
  const auto add = [&](const std::array<std::string, 3>& names) {
    Axes axes{}, others{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const auto* column : find_columns(packing, path, names[axis]))
        (axes[axis] == nullptr ? axes : others)[axis] = column;
    for (const Axes& one : {axes, others})
      if (one[0] || one[1] || one[2]) found.push_back(one);
  };
  const std::array<std::array<std::string, 3>, 4> plain = {{{"vx", "vy", "vz"},
                                                            {"v_x", "v_y", "v_z"},
                                                            {"velocity_x", "velocity_y", "velocity_z"},
                                                            {"velx", "vely", "velz"}}};
  for (const auto& names : plain) add(names);
  for (const char* vector : {"velocity", "velocities", "vel", "velo", "v", "linVelVec", "linear_velocity"})
    for (const char* pattern : {"{}:{}", "{}[{}]"}) {
      const auto axis = [&](int k) { return fmt::format(fmt::runtime(pattern), vector, k); };
      add({axis(0), axis(1), axis(2)});
    }
  return found;
}

/// Temperatures, the first of which counts. A lone T is one, a t is a time.
Columns temperature_columns(const Packing& packing, const std::string& path) {
  Columns found;
  for (const char* name : {"temperature", "temp", "f_temp", "f_temp[0]"})
    for (const auto* column : find_columns(packing, path, name)) found.push_back(column);
  for (const auto* column : find_columns(packing, path, "T", Letters::same)) found.push_back(column);
  return found;
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

/// Refuses two columns of one quantity that say something else of a particle.
///   unit, other_unit  of what they hold
void require_agreement(const PackingAttribute& column, double unit, const PackingAttribute& other,
                       double other_unit, const Packing& packing, const std::string& path) {
  constexpr double rounding = 1e-9;  // of what a program wrote with few digits in one of two units
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const double a = unit * value_at(column, packing, k, path),
                 b = other_unit * value_at(other, packing, k, path);
    if (std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b))) continue;
    throw InputError(fmt::format(
        "{}: columns '{}' and '{}' contradict each other: particle {} has {} and {}; keep the right one",
        packing.columns_place.empty() ? path : packing.columns_place, column.name, other.name, packing.id[k],
        column.value[k], other.value[k]));
  }
}

/// Columns that nobody has asked for. `current` and `potential` are what a press writes and finds anew.
std::vector<std::string> others_than(const Columns& used, const Packing& packing) {
  std::vector<std::string> names;
  for (const auto& attribute : packing.attributes)
    if (std::find(used.begin(), used.end(), &attribute) == used.end() && attribute.name != "current" &&
        attribute.name != "potential")
      names.push_back(attribute.name);
  return names;
}

[[noreturn]] void unknown(const CsvReader& rows, std::int64_t id) {
  throw InputError(fmt::format("{}: particle {} is not in the packing; remove the row", rows.where(), id));
}

}  // namespace

Kinematics read_kinematics(const std::string& path, const Packing& packing, std::optional<double> unit) {
  Kinematics out;
  Columns used;
  const std::string& names_at = packing.columns_place.empty() ? path : packing.columns_place;
  const auto velocities = velocity_columns(packing, names_at);
  const auto unit_of = [&](const PackingAttribute& column) {
    const auto stated = stated_velocity_unit(column, names_at);
    if (stated && unit && *stated != *unit)
      throw InputError(fmt::format("{}: column '{}' says another unit than velocity_unit = {} m/s; keep one",
                                   names_at, column.name, *unit));
    return stated ? *stated : unit ? *unit : velocity_unit(packing, path);
  };
  if (!velocities.empty()) {
    const Axes& axes = velocities.front();
    std::array<double, 3> metres_per_second{};
    const char* names[] = {"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!axes[axis] && !(axis == 2 && is_flat(packing)))
        throw InputError(fmt::format("{}: has velocities, but none along {}; add the column, or remove them",
                                     names_at, names[axis]));
      if (axes[axis]) metres_per_second[axis] = unit_of(*axes[axis]);
    }
    const auto along = [&](std::size_t axis, std::size_t k) {
      return axes[axis] ? metres_per_second[axis] * value_at(*axes[axis], packing, k, path) : 0.0;
    };
    for (std::size_t k = 0; k < packing.size(); ++k)
      out.velocity.push_back({along(0, k), along(1, k), along(2, k)});
    for (const Axes& others : velocities)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!others[axis]) continue;
        used.push_back(others[axis]);
        if (axes[axis])
          require_agreement(*axes[axis], metres_per_second[axis], *others[axis], unit_of(*others[axis]),
                            packing, path);
      }
  }
  const auto temperatures = temperature_columns(packing, names_at);
  for (const auto* column : temperatures) {
    require_column_unit(column->name, "K", names_at);
    used.push_back(column);
    require_agreement(*temperatures.front(), 1, *column, 1, packing, path);
  }
  for (std::size_t k = 0; k < packing.size() && !temperatures.empty(); ++k) {
    const auto& column = *temperatures.front();
    const double kelvin = value_at(column, packing, k, path);
    if (!(kelvin >= 0))
      throw InputError(
          fmt::format("{}: particle {} has the temperature {} in its column '{}'; it must be "
                      ">= 0 K",
                      path, packing.id[k], kelvin, column.name));
    out.temperature.push_back(kelvin);
  }
  out.unused = others_than(used, packing);
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
