#include "packing/formats/packing_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "core/error.hpp"

namespace superstep {
namespace {

/// Equal centres have equal hashes; -0 counts as 0.
std::uint64_t hash(Vec3 centre) noexcept {
  std::uint64_t mixed = 0;
  for (const double coordinate : {centre.x, centre.y, centre.z}) {
    mixed ^= std::bit_cast<std::uint64_t>(coordinate + 0.0);
    mixed *= 0x9E3779B97F4A7C15u;  // any large odd number
    mixed ^= mixed >> 32;
  }
  return mixed;
}

bool same_point(Vec3 a, Vec3 b) noexcept {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// The first sphere in file order that repeats an earlier one, with the one it repeats; {n, n} when there is
/// none. Spheres are the same when their keys are equal and same(i, j) holds.
template <class Same>
std::pair<std::size_t, std::size_t> first_repeat(std::vector<std::pair<std::uint64_t, std::size_t>> keys,
                                                 const Same& same) {
  std::sort(keys.begin(), keys.end());
  std::pair<std::size_t, std::size_t> found{keys.size(), keys.size()};
  for (std::size_t k = 0; k < keys.size(); ++k)
    for (std::size_t l = k + 1; l < keys.size() && keys[l].first == keys[k].first; ++l)
      if (same(keys[k].second, keys[l].second)) {
        found = std::min(found, {keys[l].second, keys[k].second});
        break;
      }
  return found;
}

}  // namespace

PackingBuilder::PackingBuilder(std::string path, double unit, std::string row)
    : path_(std::move(path)), unit_(unit), row_(std::move(row)) {}

std::string PackingBuilder::where(std::size_t line) const {
  return row_ == "line" ? fmt::format("{}:{}", path_, line) : fmt::format("{}: {} {}", path_, row_, line);
}

/// Lengths whose cubes and squares stay clear of overflow and underflow.
double PackingBuilder::metres(std::size_t line, double length, std::string_view what) const {
  constexpr double smallest = 1e-30, largest = 1e30;
  const double value = unit_ * length, size = std::abs(value);
  if (size > largest || (size < smallest && what == "radius"))
    throw InputError(
        fmt::format("{}: {} is {} units of {} m; lengths must lie between 1e-30 and 1e30 m; check the value "
                    "and the length unit",
                    where(line), what, length, unit_));
  return value;
}

void PackingBuilder::require_materials() const {
  if (packing_.material.empty() || packing_.material.size() == packing_.size()) return;
  throw InputError(
      fmt::format("{}: the particle has no material, and others have one; name a material in every row or in "
                  "none",
                  where(line_.back())));
}

void PackingBuilder::add(std::size_t line, std::int64_t id, Vec3 centre, double radius) {
  require_materials();
  if (!(radius > 0))
    throw InputError(fmt::format("{}: radius is {}; it must be > 0; correct it or remove the particle",
                                 where(line), radius));
  packing_.id.push_back(id);
  packing_.centre.push_back(
      {metres(line, centre.x, "x"), metres(line, centre.y, "y"), metres(line, centre.z, "z")});
  packing_.radius.push_back(metres(line, radius, "radius"));
  line_.push_back(line);
}

void PackingBuilder::set_material(std::string_view name) {
  auto& names = packing_.material_names;
  auto& material = packing_.material;
  if (material.size() + 1 != packing_.size())
    throw InputError(
        fmt::format("{}: the particle has a material, and earlier ones have none; name a material in every "
                    "row or in none",
                    where(line_.empty() ? 0 : line_.back())));
  if (!material.empty() && name == names[static_cast<std::size_t>(material.back())]) {
    material.push_back(material.back());
    return;
  }
  const auto next = static_cast<std::int32_t>(names.size());
  const auto [entry, is_new] = material_index_.try_emplace(std::string(name), next);
  if (is_new) names.emplace_back(name);
  material.push_back(entry->second);
}

void PackingBuilder::drop_single_material() {
  if (packing_.material_names.size() != 1) return;
  packing_.single_type = packing_.material_names.front();
  packing_.material_names.clear();
}

void PackingBuilder::check_ids() const {
  const auto& id = packing_.id;
  if (std::is_sorted(id.begin(), id.end(), std::less_equal<>())) return;  // strictly rising: nothing repeats
  std::vector<std::pair<std::uint64_t, std::size_t>> keys(id.size());
  for (std::size_t k = 0; k < id.size(); ++k) keys[k] = {static_cast<std::uint64_t>(id[k]), k};
  const auto [later, earlier] = first_repeat(std::move(keys), [](std::size_t, std::size_t) { return true; });
  if (later < id.size())
    throw InputError(
        fmt::format("{}: id is {}, as on {} {}; ids must be unique; renumber or remove one of the two",
                    where(line_[later]), id[later], row_, line_[earlier]));
}

void PackingBuilder::check_centres() const {
  const auto& centre = packing_.centre;
  std::vector<std::pair<std::uint64_t, std::size_t>> keys(centre.size());
  for (std::size_t k = 0; k < centre.size(); ++k) keys[k] = {hash(centre[k]), k};
  const auto [later, earlier] = first_repeat(
      std::move(keys), [&](std::size_t i, std::size_t j) { return same_point(centre[i], centre[j]); });
  if (later < centre.size())
    throw InputError(fmt::format(
        "{}: centre is ({}, {}, {}) m, as on {} {}; centres must differ; remove one of the two, or write "
        "the file with more digits",
        where(line_[later]), centre[later].x, centre[later].y, centre[later].z, row_, line_[earlier]));
}

Packing PackingBuilder::finish() {
  if (packing_.radius.empty())
    throw InputError(fmt::format("{}: has a header but no particles; at least one is needed", path_));
  require_materials();
  check_ids();
  check_centres();
  if (packing_.material.empty()) packing_.material.assign(packing_.size(), 0);
  return std::move(packing_);
}

}  // namespace superstep
