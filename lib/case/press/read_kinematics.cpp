#include "case/press/read_kinematics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <unordered_map>

#include "core/error.hpp"
#include "core/text/csv.hpp"
#include "core/text/number.hpp"
#include "core/text/text_file.hpp"

namespace superstep::dynamics {
namespace {

using Places = std::unordered_map<std::int64_t, std::size_t>;

Places places_of(const Packing& packing) {
  Places places;
  for (std::size_t k = 0; k < packing.size(); ++k) places.emplace(packing.id[k], k);
  return places;
}

std::vector<std::string_view> words(std::string_view line) {
  constexpr std::string_view blanks = " \t\r";
  std::vector<std::string_view> out;
  for (std::size_t at = 0; (at = line.find_first_not_of(blanks, at)) != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    out.push_back(line.substr(at, end - at));
    at = end;
  }
  return out;
}

double finite(const std::string& path, std::size_t line, std::string_view text, const char* what) {
  const auto value = parse_number(text);
  if (!value || !std::isfinite(*value))
    throw InputError(
        fmt::format("{}:{}: {} is {}; it must be a finite number", path, line, what, quoted(text)));
  return *value;
}

double kelvin(const std::string& where, double value) {
  if (!(value >= 0)) throw InputError(fmt::format("{}: temperature is {}; it must be >= 0 K", where, value));
  return value;
}

/// The last frame of a dump; every row was checked when the packing was read.
Kinematics of_dump(const std::string& path, const std::string& text, double unit, const Packing& packing) {
  constexpr std::string_view atoms = "ITEM: ATOMS";
  const std::size_t start = text.rfind(atoms);
  if (start == std::string::npos) return {};
  const auto skipped = static_cast<std::size_t>(
      std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(start), '\n'));
  LineReader lines(std::string_view(text).substr(start));
  (void)lines.next();
  auto names = words(lines.line());
  names.erase(names.begin(), names.begin() + 2);
  const auto column = [&](std::initializer_list<std::string_view> any) -> std::optional<std::size_t> {
    for (const auto name : any)
      if (const auto at = std::find(names.begin(), names.end(), name); at != names.end())
        return static_cast<std::size_t>(at - names.begin());
    return std::nullopt;
  };
  const auto id = column({"id"}), vx = column({"vx"}), vy = column({"vy"}), vz = column({"vz"}),
             heat = column({"temperature", "Temp", "f_Temp", "f_Temp[0]"});
  Kinematics out;
  const bool moves = vx && vy && vz;
  if (moves) out.velocity.resize(packing.size());
  if (heat) out.temperature.resize(packing.size());
  if (!moves && !heat) return out;
  const Places places = places_of(packing);
  for (std::size_t row = 0; lines.next();) {
    const auto cells = words(lines.line());
    if (cells.empty()) continue;
    const std::size_t line = skipped + lines.number();
    const auto number = id ? parse_integer(cells[*id]) : static_cast<std::int64_t>(row);
    ++row;
    const std::size_t k = places.at(number.value());
    if (moves)
      out.velocity[k] =
          unit * Vec3{finite(path, line, cells[*vx], "vx"), finite(path, line, cells[*vy], "vy"),
                      finite(path, line, cells[*vz], "vz")};
    if (heat)
      out.temperature[k] =
          kelvin(fmt::format("{}:{}", path, line), finite(path, line, cells[*heat], "temperature"));
  }
  return out;
}

/// The last frame of a MercuryDPM .data file, whose rows are x y z, velocity, ...
Kinematics of_mercury(const std::string& path, const std::string& text, double unit, const Packing& packing) {
  Kinematics out;
  LineReader lines(text);
  while (lines.next()) {
    if (words(lines.line()).empty()) continue;
    out.velocity.assign(packing.size(), {});
    const auto count = static_cast<std::size_t>(parse_integer(words(lines.line())[0]).value());
    for (std::size_t k = 0; k < count && lines.next();) {
      const auto cells = words(lines.line());
      if (cells.empty()) continue;
      if (k < packing.size())
        out.velocity[k] = unit * Vec3{finite(path, lines.number(), cells[3], "vx"),
                                      finite(path, lines.number(), cells[4], "vy"),
                                      finite(path, lines.number(), cells[5], "vz")};
      ++k;
    }
  }
  return out;
}

bool is_mercury(const std::string& text) {
  LineReader lines(text);
  while (lines.next()) {
    const auto cells = words(lines.line());
    if (cells.empty()) continue;
    constexpr std::size_t header = 8;
    return cells.size() == header && std::all_of(cells.begin(), cells.end(), [](std::string_view cell) {
             return parse_number(cell).has_value();
           });
  }
  return false;
}

[[noreturn]] void unknown(const CsvReader& rows, std::int64_t id) {
  throw InputError(fmt::format("{}: particle {} is not in the packing; remove the row", rows.where(), id));
}

}  // namespace

Kinematics read_kinematics(const std::string& path, double unit, const Packing& packing) {
  const std::string text = read_text_file(path);
  if (text.starts_with("ITEM:")) return of_dump(path, text, unit, packing);
  if (is_mercury(text)) return of_mercury(path, text, unit, packing);
  return {};
}

Kinematics read_state(const std::string& path, const Packing& packing) {
  enum Column : std::size_t { id, vx, vy, vz, temperature };
  CsvReader rows(path, {"id"}, {"vx", "vy", "vz", "temperature"});
  const Places places = places_of(packing);
  Kinematics out;
  if (rows.has(vx) || rows.has(vy) || rows.has(vz)) out.velocity.resize(packing.size());
  if (rows.has(temperature)) out.temperature.resize(packing.size());
  std::vector<char> seen(packing.size(), 0);
  while (rows.next()) {
    const auto found = places.find(rows.integer(id));
    if (found == places.end()) unknown(rows, rows.integer(id));
    const std::size_t k = found->second;
    if (seen[k])
      throw InputError(
          fmt::format("{}: particle {} has a row already; keep one", rows.where(), rows.integer(id)));
    seen[k] = 1;
    const auto value = [&](Column column) { return rows.has(column) ? rows.number(column) : 0.0; };
    if (!out.velocity.empty()) out.velocity[k] = {value(vx), value(vy), value(vz)};
    if (rows.has(temperature)) out.temperature[k] = kelvin(rows.where(), rows.number(temperature));
  }
  for (std::size_t k = 0; k < seen.size(); ++k)
    if (!seen[k])
      throw InputError(fmt::format("{}: has no row for particle {} of the packing; give every one a row",
                                   path, packing.id[k]));
  return out;
}

std::vector<Bond> read_bonds(const std::string& path, const Packing& packing) {
  enum Column : std::size_t { i, j, overlap, growth };
  CsvReader rows(path, {"i", "j", "overlap", "growth"});
  const Places places = places_of(packing);
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
