#include "contact/neck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "contact/neck_laws.hpp"
#include "core/error.hpp"

namespace superstep {

std::span<const NeckLaw> neck_laws() {
  static const std::array laws{neck_volume_preserving(), neck_coble(), neck_geometric(), neck_hertz(),
                               neck_plastic()};
  return laws;
}

const NeckLaw* find_neck_law(const std::string& name) {
  const auto laws = neck_laws();
  const auto law = std::find_if(laws.begin(), laws.end(), [&](const NeckLaw& l) { return l.name == name; });
  return law == laws.end() ? nullptr : &*law;
}

NeckReport apply_neck_law(const Packing& packing, const NeckLaw& law, const NeckParameters& parameters,
                          Contacts& contacts) {
  NeckReport report;
  contacts.neck_radius.resize(contacts.size());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto i = static_cast<std::size_t>(contacts.i[k]), j = static_cast<std::size_t>(contacts.j[k]);
    const double r_i = packing.radius[i], r_j = packing.radius[j], overlap = contacts.overlap[k];
    if (!(overlap > 0) && !(parameters.bond_radius > 0))
      throw InputError(fmt::format(
          "contact {}-{}: overlap is {} m; neck law '{}' needs an overlap > 0: give bond_radius, or the neck "
          "radius of a bond across a gap in a contact file",
          packing.id[i], packing.id[j], overlap, law.name));
    const double own = overlap > 0 ? law.radius(r_i, r_j, overlap, parameters) : 0.0;
    const double formula = std::max(own, parameters.bond_radius), smaller = std::min(r_i, r_j);
    if (overlap > saturation_overlap(r_i, r_j)) ++report.saturated;
    if (formula >= smaller) ++report.limited;
    contacts.neck_radius[k] = std::min(formula, smaller);
  }
  return report;
}

}  // namespace superstep
