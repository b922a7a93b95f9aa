#include "case/packed/read_contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "case/inputs/named_file.hpp"
#include "case/read_packing_scene.hpp"
#include "contact/search.hpp"
#include "core/error.hpp"
#include "core/text/csv.hpp"
#include "core/text/ids_in_words.hpp"
#include "core/text/quantity.hpp"
#include "core/text/suggest.hpp"
#include "packing/formats/stated.hpp"
#include "packing/units.hpp"

namespace superstep {
namespace {

using Image = std::array<std::int8_t, 3>;

struct Neck {
  std::int32_t i, j;
  double radius;
  std::size_t line;
};

/// Metres per unit of the radii: as their column says, or a comment of the file, or else as in the packing.
double unit_of_necks(const CsvReader& rows, const std::string& path, std::size_t radius, double usual) {
  const auto stated = stated_length_unit(path, rows.content());
  const std::string_view unit = rows.unit(radius);
  if (unit.empty()) return stated ? stated->metres : usual;
  const auto metres = length_unit_of_column(std::string(unit));
  if (!metres)
    throw InputError(fmt::format("{}: radii are in {}; valid units are: m, cm, mm, um, nm",
                                 rows.where_header(), in_quotes(unit)));
  if (stated && stated->metres != *metres)
    throw InputError(fmt::format("{}: radii are in {} by their column, and in {}; keep one",
                                 rows.where_header(), unit, stated->words));
  return *metres;
}

/// Rows `i,j,radius` by ids of the packing, sorted; no pair twice.
std::vector<Neck> read_necks(const std::string& path, const PackingScene& scene) {
  enum : std::size_t { i, j, radius };
  const auto& packing = scene.packing;
  std::unordered_map<std::int64_t, std::int32_t> position;
  for (std::size_t k = 0; k < packing.size(); ++k)
    position.emplace(packing.id[k], static_cast<std::int32_t>(k));
  std::vector<Neck> necks;
  CsvReader rows(path, {"i", "j", "radius"}, {}, {"radius"});
  const double unit = unit_of_necks(rows, path, radius, scene.length_unit);
  while (rows.next()) {
    const auto a = position.find(rows.integer(i)), b = position.find(rows.integer(j));
    if (a == position.end() || b == position.end())
      throw InputError(
          fmt::format("{}: contact {}-{} names an unknown id; both must be particles of the packing: {}",
                      rows.where(), rows.integer(i), rows.integer(j), ids_in_words(packing.id)));
    if (a->second == b->second || !(rows.number(radius) > 0))
      throw InputError(
          fmt::format("{}: contact {}-{} with neck radius {}; it must join two particles and be > 0",
                      rows.where(), rows.integer(i), rows.integer(j), rows.number(radius)));
    necks.push_back({std::min(a->second, b->second), std::max(a->second, b->second),
                     unit * rows.number(radius), rows.line()});
  }
  std::sort(necks.begin(), necks.end(), [](const Neck& a, const Neck& b) {
    return std::tie(a.i, a.j, a.line) < std::tie(b.i, b.j, b.line);
  });
  for (std::size_t k = 1; k < necks.size(); ++k)
    if (necks[k - 1].i == necks[k].i && necks[k - 1].j == necks[k].j)
      throw InputError(fmt::format("{}:{}: this contact stands already in line {}; keep one", path,
                                   necks[k].line, necks[k - 1].line));
  return necks;
}

/// Radii as they are; but where one is wider than its particles, a unit may be wrong, or it is a diameter.
void warn_of_wide_necks(const std::string& file, const std::vector<Neck>& necks, PackingScene& scene) {
  constexpr double rounding = 1e-6;  // of what was written with few digits
  const auto radius = [&](std::int32_t k) { return scene.packing.radius[static_cast<std::size_t>(k)]; };
  const auto wide = [&](const Neck& neck) {
    return neck.radius > (1 + rounding) * std::min(radius(neck.i), radius(neck.j));
  };
  const auto first = std::find_if(necks.begin(), necks.end(), wide);
  if (first == necks.end()) return;
  scene.packing.warnings.push_back(fmt::format(
      "{} of {} necks of {} are wider than their smaller particle, the first in line {}: {:.4g} beside a "
      "radius of "
      "{:.4g} [length_unit]; are they radii, and in the unit of lengths of the case?",
      std::count_if(necks.begin(), necks.end(), wide), necks.size(), file, first->line,
      first->radius / scene.length_unit, std::min(radius(first->i), radius(first->j)) / scene.length_unit));
}

/// The image of j nearest to i, in a periodic cell. Exact where the cell is not much tilted: the images next
/// to the rounded one are tried as well.
Image nearest_image(const Packing& packing, std::size_t i, std::size_t j) {
  Image best{};
  if (!packing.cell || !packing.cell->is_periodic()) return best;
  const Cell& cell = *packing.cell;
  double smallest = norm(packing.centre[j] - packing.centre[i]);
  for (int a = -1; a <= 1; ++a)
    for (int b = -1; b <= 1; ++b)
      for (int c = -1; c <= 1; ++c) {
        if ((a != 0 && !cell.periodic[0]) || (b != 0 && !cell.periodic[1]) || (c != 0 && !cell.periodic[2]))
          continue;
        const double distance = norm(packing.centre[j] + cell.shift({a, b, c}) - packing.centre[i]);
        if (!(distance < smallest)) continue;
        smallest = distance;
        best = {static_cast<std::int8_t>(a), static_cast<std::int8_t>(b), static_cast<std::int8_t>(c)};
      }
  return best;
}

/// A neck may bridge a gap, but hardly one as wide as both particles: ids may be those of another packing.
void warn_of_far_necks(const std::string& file, const std::vector<Neck>& necks, PackingScene& scene) {
  const auto& packing = scene.packing;
  const auto distance = [&](const Neck& neck) {
    const auto i = static_cast<std::size_t>(neck.i), j = static_cast<std::size_t>(neck.j);
    const Image at = nearest_image(packing, i, j);
    const Vec3 shift = packing.cell ? packing.cell->shift({at[0], at[1], at[2]}) : Vec3{};
    return norm(packing.centre[j] + shift - packing.centre[i]);
  };
  const auto radii = [&](const Neck& neck) {
    return packing.radius[static_cast<std::size_t>(neck.i)] +
           packing.radius[static_cast<std::size_t>(neck.j)];
  };
  const auto far = [&](const Neck& neck) { return distance(neck) > 2 * radii(neck); };
  const auto first = std::find_if(necks.begin(), necks.end(), far);
  if (first == necks.end()) return;
  scene.packing.warnings.push_back(fmt::format(
      "{} of {} necks of {} join particles far from each other, the first in line {}: {:.4g} from centre to "
      "centre beside radii of {:.4g} together [length_unit]; are its ids those of this packing?",
      std::count_if(necks.begin(), necks.end(), far), necks.size(), file, first->line,
      distance(*first) / scene.length_unit, radii(*first) / scene.length_unit));
}

std::vector<Neck> necks_of(const TomlValue& file, PackingScene& scene) {
  auto necks = read_named_file(file, [&](const auto& path) { return read_necks(path, scene); });
  warn_of_wide_necks(file.string(), necks, scene);
  warn_of_far_necks(file.string(), necks, scene);
  return necks;
}

void add_neck(const Packing& packing, const Neck& neck, Contacts& contacts) {
  const auto a = static_cast<std::size_t>(neck.i), b = static_cast<std::size_t>(neck.j);
  contacts.i.push_back(neck.i);
  contacts.j.push_back(neck.j);
  contacts.neck_radius.push_back(neck.radius);
  if (packing.cell && packing.cell->is_periodic()) contacts.image.push_back(nearest_image(packing, a, b));
  contacts.overlap.push_back(packing.radius[a] + packing.radius[b] -
                             norm(branch(packing, contacts, contacts.i.size() - 1)));
}

/// Neck radii of a file are those of the contacts that the search found (all of them where a pair touches
/// several times), or make contacts of their own.
void add_bonds(const std::vector<Neck>& bonds, const Packing& packing, Contacts& contacts) {
  std::map<std::pair<std::int32_t, std::int32_t>, bool> known;
  std::map<std::pair<std::int32_t, std::int32_t>, double> radius;
  for (const auto& bond : bonds) radius[{bond.i, bond.j}] = bond.radius;
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (const auto found = radius.find({contacts.i[k], contacts.j[k]}); found != radius.end()) {
      contacts.neck_radius[k] = found->second;
      known[found->first] = true;
    }
  for (const auto& bond : bonds)
    if (!known.contains({bond.i, bond.j})) add_neck(packing, bond, contacts);
}

void sort_contacts(Contacts& contacts) {
  std::vector<std::size_t> order(contacts.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(contacts.i[a], contacts.j[a]) < std::pair(contacts.i[b], contacts.j[b]);
  });
  const auto permute = [&](auto& list) {
    if (list.empty()) return;
    auto old = list;
    for (std::size_t k = 0; k < order.size(); ++k) list[k] = old[order[k]];
  };
  permute(contacts.i);
  permute(contacts.j);
  permute(contacts.overlap);
  permute(contacts.neck_radius);
  permute(contacts.image);
}

/// Pairs that touch without overlapping conduct nothing, and their user should know.
void warn_of_touching(PackingScene& scene) {
  if (2 * scene.contacts.size() > scene.packing.size()) return;
  constexpr double nearly = 1e-3;  // of the smallest radius
  const double gap = nearly * *std::min_element(scene.packing.radius.begin(), scene.packing.radius.end());
  const std::size_t close = find_contacts(scene.packing, gap).size();
  if (close > 2 * scene.contacts.size())
    scene.packing.warnings.push_back(
        fmt::format("{} of particles touch, or nearly, without overlapping, and do not conduct: "
                    "[contact] gap = {:.2g} "
                    "with bond_radius joins them",
                    quantity(close - scene.contacts.size(), "pair"), gap / scene.length_unit));
}

const NeckLaw& read_law(const TomlValue& neck) {
  if (const NeckLaw* law = find_neck_law(neck.string())) return *law;
  std::vector<std::string> names = {"given"};
  for (const auto& known : neck_laws()) names.push_back(known.name);
  neck.reject("it must name a neck law" + suggestion(neck.string(), names));
}

}  // namespace

void read_contacts(TomlTable& table, const std::string& place, PackingScene& scene) {
  const auto neck = table.require("neck", "it names the neck law, e.g. \"volume-preserving\"");
  const auto gap = table.find("gap"), bond_radius = table.find("bond_radius"), bonds = table.find("bonds");
  scene.neck = neck.string();
  const auto hardening = table.find("hardening");
  if (scene.neck == "given") {
    for (const auto& other : {gap, bond_radius, bonds, hardening})
      if (other)
        other->reject("with neck = \"given\" the file lists every contact, across any gap; leave this out");
    const auto file = table.require("file", "with neck = \"given\" it names a CSV with i,j,radius");
    for (const auto& one : necks_of(file, scene)) add_neck(scene.packing, one, scene.contacts);
    return;
  }
  const NeckLaw& law = read_law(neck);
  NeckParameters parameters;
  if (hardening) {
    const auto& taken = law.parameters;
    if (std::find(taken.begin(), taken.end(), "hardening") == taken.end())
      hardening->reject(fmt::format("neck = \"{}\" takes none; leave it out, or take \"plastic\"", law.name));
    parameters.hardening = hardening->number();
    if (!(parameters.hardening >= 0.5 && parameters.hardening <= 1.45))
      hardening->reject("it must lie between 0.5 (linear hardening) and 1.45 (perfectly plastic)");
  }
  if (gap && !(gap->number() >= 0)) gap->reject("it must be >= 0 [length_unit]");
  if (bond_radius) parameters.bond_radius = scene.length_unit * table.positive("bond_radius", "length");
  if (gap && gap->number() > 0 && !bond_radius)
    table.missing(
        "bond_radius",
        "bond_radius is missing: a contact across a gap has no overlap that a neck law could work with; give "
        "the radius of such a neck [length_unit]");
  try {
    scene.contacts = find_contacts(scene.packing, gap ? scene.length_unit * gap->number() : 0.0);
  } catch (const InputError& error) {  // of a file it names that
    if (!scene.packing.place.empty()) throw;
    throw InputError(fmt::format("{}: {}", place, error.what()));
  }
  scene.neck_report = apply_neck_law(scene.packing, law, parameters, scene.contacts);
  if (bonds) {
    add_bonds(necks_of(*bonds, scene), scene.packing, scene.contacts);
    sort_contacts(scene.contacts);
  }
  if (!gap && !bonds) warn_of_touching(scene);
}

}  // namespace superstep
