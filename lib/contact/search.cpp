#include "contact/search.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "packing/near_pairs.hpp"

namespace superstep {
namespace {

[[noreturn]] void refuse_swallowed(const Packing& packing, std::size_t i, std::size_t j, double distance) {
  const bool i_is_inner = packing.radius[i] < packing.radius[j];
  const std::size_t inner = i_is_inner ? i : j, outer = i_is_inner ? j : i;
  throw InputError(fmt::format(
      "particle {} (radius {} m) lies inside particle {} (radius {} m), {} m from its centre; two spheres in "
      "contact must "
      "both reach out of each other: remove the inner one, or check the length unit and the radii",
      packing.id[inner], packing.radius[inner], packing.id[outer], packing.radius[outer], distance));
}

}  // namespace

Contacts find_contacts(const Packing& packing, double gap) {
  Contacts contacts;
  for (const auto [first, second] : near_pairs(packing.centre, packing.radius, gap)) {
    const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
    const double distance = norm(packing.centre[i] - packing.centre[j]);
    const double overlap = packing.radius[i] + packing.radius[j] - distance;
    if (!(overlap > -gap)) continue;
    if (distance <= std::abs(packing.radius[i] - packing.radius[j]))
      refuse_swallowed(packing, i, j, distance);
    contacts.i.push_back(first);
    contacts.j.push_back(second);
    contacts.overlap.push_back(overlap);
  }
  return contacts;
}

}  // namespace superstep
