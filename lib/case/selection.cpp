#include "case/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "core/error.hpp"
#include "core/text/ids_in_words.hpp"
#include "core/text/suggest.hpp"

namespace superstep {
namespace {

Vec3 point(TomlTable& table, const std::string& key, double unit) {
  const auto value = table.require(key, "it must be [x, y, z]");
  const auto numbers = value.numbers();
  if (numbers.size() != 3) value.reject("it must have three numbers [x, y, z]");
  return unit * Vec3{numbers[0], numbers[1], numbers[2]};
}

template <class Inside>
std::vector<char> mask(const Packing& packing, Inside inside) {
  std::vector<char> out(packing.size());
  for (std::size_t k = 0; k < packing.size(); ++k) out[k] = inside(packing.centre[k]) ? 1 : 0;
  return out;
}

/// Centres no deeper than `thickness` below the outermost surface point on the side ("+z", "-x", ...).
std::vector<char> layer(const Packing& packing, char sign, char axis, double thickness) {
  const Bounds bounds = surface_bounds(packing);
  if (sign == '+') {
    const double limit = component(bounds.max, axis) - thickness;
    return mask(packing, [&](Vec3 c) { return component(c, axis) >= limit; });
  }
  const double limit = component(bounds.min, axis) + thickness;
  return mask(packing, [&](Vec3 c) { return component(c, axis) <= limit; });
}

std::vector<char> named_layer(const TomlValue& where, const std::string& side, const Packing& packing,
                              double thickness) {
  static const std::vector<std::string> sides = {"top", "bottom", "+x", "-x", "+y", "-y", "+z", "-z"};
  if (std::find(sides.begin(), sides.end(), side) == sides.end())
    where.reject("the side must be one of top, bottom, +x, -x, +y, -y, +z, -z" + near_miss(side, sides));
  if (side == "top") return layer(packing, '+', 'z', thickness);
  if (side == "bottom") return layer(packing, '-', 'z', thickness);
  return layer(packing, side[0], side[1], thickness);
}

double mean_diameter(const Packing& packing) {
  if (packing.mean_diameter) return *packing.mean_diameter;
  return 2 * std::accumulate(packing.radius.begin(), packing.radius.end(), 0.0) /
         static_cast<double>(packing.size());
}

/// Notes whether what stands at a place of the case held anybody.
void note(const TomlValue& value, bool found, SelectionLog& log) {
  bool& somebody = log.try_emplace(value.where() + " is " + value.shown()).first->second;
  somebody = somebody || found;
}

std::vector<char> by_ids(const TomlValue& ids, const Packing& packing, SelectionLog* log) {
  if (ids.array().empty()) ids.reject("it must hold at least one id");
  std::unordered_map<std::int64_t, std::size_t> position;
  for (std::size_t k = 0; k < packing.size(); ++k) position.emplace(packing.id[k], k);
  const auto may_be_elsewhere = [&](std::int64_t id) {
    if (!packing.part_of) return false;
    return !packing.part_of->ids_count || (id >= 0 && id < packing.part_of->particles);
  };
  std::vector<char> out(packing.size(), 0);
  for (const auto& id : ids.array()) {
    const auto found = position.find(id.integer());
    if (found == position.end() && !may_be_elsewhere(id.integer()))
      id.reject(
          "it must be the id of a particle in the packing; " +
          (packing.part_of ? ids_in_words(0, packing.part_of->particles - 1) : ids_in_words(packing.id)));
    if (found != position.end()) out[found->second] = 1;
    if (log && packing.part_of && !packing.part_of->ids_count) note(id, found != position.end(), *log);
  }
  return out;
}

/// One way to select, not two of which the later would win.
void require_one_selector(const TomlValue& where, TomlTable& table) {
  std::string first;
  for (const char* key : {"ids", "box", "layer", "sphere", "cylinder"}) {
    if (!table.find(key)) continue;
    if (!first.empty())
      where.reject(
          fmt::format("it holds '{}' and '{}'; give one, and an entry of its own for the other", first, key));
    first = key;
  }
  if (first.empty()) table.missing("ids", "it must hold ids, box, layer, sphere or cylinder");
}

std::vector<char> by_table(const TomlValue& where, const Packing& packing, double unit, SelectionLog* log) {
  TomlTable table = where.table();
  require_one_selector(where, table);
  std::vector<char> out;
  if (const auto ids = table.find("ids")) out = by_ids(*ids, packing, log);
  if (auto box = table.table("box")) {
    const Vec3 low = point(*box, "min", unit), high = point(*box, "max", unit);
    out = mask(packing, [&](Vec3 c) {
      return c.x >= low.x && c.x <= high.x && c.y >= low.y && c.y <= high.y && c.z >= low.z && c.z <= high.z;
    });
  }
  if (auto slab = table.table("layer")) {
    const auto side = slab->require("side", "it names the side, e.g. \"top\"");
    out = named_layer(side, side.string(), packing, unit * slab->positive("thickness", "length"));
  }
  if (auto sphere = table.table("sphere")) {
    const Vec3 centre = point(*sphere, "centre", unit);
    const double radius = unit * sphere->positive("radius", "length");
    out = mask(packing, [&](Vec3 c) { return norm(c - centre) <= radius; });
  }
  if (auto cylinder = table.table("cylinder")) {
    const Vec3 base = point(*cylinder, "base", unit), direction = point(*cylinder, "axis", 1.0);
    const double radius = unit * cylinder->positive("radius", "length");
    const double height = unit * cylinder->positive("height", "length");
    if (!(norm(direction) > 0)) where.reject("the axis of a cylinder must not be [0, 0, 0]");
    const Vec3 axis = (1 / norm(direction)) * direction;
    out = mask(packing, [&](Vec3 c) {
      const double along = dot(c - base, axis);
      return along >= 0 && along <= height && norm(c - base - along * axis) <= radius;
    });
  }
  table.finish();
  return out;
}

}  // namespace

std::vector<char> select_particles(const TomlValue& where, const Packing& packing, double unit,
                                   SelectionLog* log) {
  std::vector<char> out;
  if (where.is_string()) {
    const std::string name = where.string();
    if (name == "all")
      out.assign(packing.size(), 1);
    else
      out = named_layer(where, name, packing, mean_diameter(packing));  // one mean diameter thick
  } else if (where.is_table()) {
    out = by_table(where, packing, unit, log);
  } else {
    where.reject("it must be \"all\", \"top\", \"bottom\" or a table such as { ids = [1, 2] }");
  }
  const bool nobody = std::none_of(out.begin(), out.end(), [](char chosen) { return chosen != 0; });
  if (log)
    note(where, !nobody, *log);
  else if (nobody)
    where.reject(selects_nobody);
  return out;
}

}  // namespace superstep
