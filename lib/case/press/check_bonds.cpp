#include "case/press/check_bonds.hpp"

#include <fmt/format.h>

#include <tuple>

#include "core/index.hpp"
#include "core/text/quantity.hpp"
#include "dynamics/contacts/bond_registry.hpp"
#include "dynamics/laws/contact_law.hpp"

namespace superstep::dynamics {

std::optional<std::string> torn_bonds(const ModelInput& input, const std::string& path) {
  const auto& law = input.model.bond;
  const auto& id = input.particles.id;
  const auto& radius = input.particles.radius;
  const auto& position = input.state.position;
  const auto distance_of = [&](const Bond& bond) {
    return norm(position[at(bond.j)] - position[at(bond.i)]);
  };
  const Bond* worst = nullptr;
  double strain = 0;
  std::size_t torn = 0;
  for (const Bond& bond : input.state.bonds) {
    const double own = pair_strain(distance_of(bond), radius[at(bond.i)] + radius[at(bond.j)]);
    if (!switches(bond_kind(law.rule).margin(law, own, {bond.overlap, bond.growth}, true), true)) continue;
    ++torn;
    if (worst && own <= strain) continue;
    worst = &bond;
    strain = own;
  }
  if (!worst) return std::nullopt;
  return fmt::format(
      "{}: {} at once: {}-{} has a strain of {:.4g}, its particles being {:.4g} m apart; check which "
      "particles "
      "it joins",
      path, quantity(torn, "bond breaks", "bonds break"), id[at(worst->i)], id[at(worst->j)], strain,
      distance_of(*worst));
}

}  // namespace superstep::dynamics
