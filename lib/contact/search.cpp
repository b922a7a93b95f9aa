#include "contact/search.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "core/error.hpp"
#include "packing/near_pairs.hpp"
#include "packing/periodic_pairs.hpp"

namespace superstep {
namespace {

[[noreturn]] void refuse_swallowed(const Packing& packing, std::size_t i, std::size_t j, double distance) {
  const bool i_is_inner = packing.radius[i] < packing.radius[j];
  const std::size_t inner = i_is_inner ? i : j, outer = i_is_inner ? j : i;
  throw InputError(fmt::format(
      "particle {} (radius {} m) lies inside particle {} (radius {} m), {} m from its centre; two spheres in "
      "contact must both reach out of each other: remove the inner one, or check the length unit and the "
      "radii",
      packing.id[inner], packing.radius[inner], packing.id[outer], packing.radius[outer], distance));
}

/// Takes a near pair as a contact if it is one.
void take(const Packing& packing, double gap, const ImagePair& pair, Contacts& contacts) {
  const auto i = static_cast<std::size_t>(pair.i), j = static_cast<std::size_t>(pair.j);
  Vec3 between = packing.centre[j] - packing.centre[i];
  const bool is_moved = pair.image != std::array<std::int8_t, 3>{};
  if (is_moved) between = between + packing.cell->shift({pair.image[0], pair.image[1], pair.image[2]});
  const double distance = norm(between);
  const double overlap = packing.radius[i] + packing.radius[j] - distance;
  if (!(overlap > -gap)) return;
  if (distance <= std::abs(packing.radius[i] - packing.radius[j])) refuse_swallowed(packing, i, j, distance);
  contacts.i.push_back(pair.i);
  contacts.j.push_back(pair.j);
  contacts.overlap.push_back(overlap);
}

Contacts contacts_of(const Packing& packing, double gap, bool own_images) {
  Contacts contacts;
  if (!packing.cell || !packing.cell->is_periodic()) {
    for (const auto [i, j] : near_pairs(packing.centre, packing.radius, gap))
      take(packing, gap, {i, j, {}}, contacts);
    return contacts;
  }
  for (const auto& pair : periodic_pairs(packing.centre, packing.radius, gap, *packing.cell)) {
    if (pair.i == pair.j && !own_images) continue;
    const std::size_t before = contacts.size();
    take(packing, gap, pair, contacts);
    if (contacts.size() > before) contacts.image.push_back(pair.image);
  }
  return contacts;
}

}  // namespace

Contacts find_contacts(const Packing& packing, double gap, bool own_images) {
  try {
    return contacts_of(packing, gap, own_images);
  } catch (const InputError& error) {
    if (packing.place.empty()) throw;
    throw InputError(fmt::format("{}: {}", packing.place, error.what()));
  }
}

}  // namespace superstep
