#include "dynamics/contacts/bond_registry.hpp"

#include <algorithm>
#include <array>

#include "core/index.hpp"
#include "dynamics/laws/bonds/overlap_bond.hpp"
#include "dynamics/laws/bonds/rest_length_bond.hpp"
#include "dynamics/laws/bonds/tension_bond.hpp"

namespace superstep::dynamics {
namespace {

BondedPair pair_of(const BondSurroundings& around, const ContactTable& table, std::size_t k) noexcept {
  const std::size_t i = at(table.i[k]), j = at(table.j[k]);
  const double temperature = 0.5 * (around.temperature[i] + around.temperature[j]);
  const double strain = table.strain[k];
  return {.strain = strain,
          .temperature = temperature,
          .pressure = strain < 0 ? softened(around.contact.stiffness, around.contact.softening, temperature) *
                                       strain_power(-strain, around.contact.exponent) * table.hardness[k]
                                 : 0,
          .mobility = around.mobility.empty() ? 1 : around.mobility[i] * around.mobility[j],
          .contact_area = table.area[k],
          .bond_area = 0,
          .radius_sum = table.radius_sum[k],
          .reduced_mass = table.reduced_mass[k]};
}

double area_at(const ContactTable& table, std::size_t k, double overlap) noexcept {
  return circle_area(table.radius_sum[k] * (1 - overlap), table.square[k],
                     table.square[k] + table.square_difference[k]);
}

template <class Law>
void act(const BondSurroundings& around, BondArrays& bonds, ContactTable& table, std::size_t first,
         std::size_t last) {
  for (std::size_t b = first; b < last; ++b) {
    const std::size_t k = bonds.pair[b];
    BondedPair pair = pair_of(around, table, k);
    BondMemory memory = bonds.begin[b];
    memory.overlap = std::max(memory.overlap, -pair.strain);
    pair.bond_area = area_at(table, k, memory.overlap);
    if constexpr (Law::grows) {
      bonds.rate_now[b] = Law::rate(around.law, pair, memory);
      memory.growth = grown(memory.growth, bonds.rate[b], bonds.rate_now[b], around.step.h, around.step.phi);
    }
    bonds.now[b] = memory;
    const BondAction action = Law::act(around.law, pair, memory);
    bonds.slope[b] = action.slope;
    table.keep[k] = action.keep;
    table.pull[k] = action.pull;
    table.damping[k] = action.damping;
    table.flow[k] = action.area / (table.radius_sum[k] * (1 + pair.strain));
  }
}

template <class Law>
constexpr BondKind kind(BondRule rule) {
  return {rule, Law::name, Law::smooth, Law::grows, &Law::margin, &act<Law>};
}

constexpr std::array kinds = {
    kind<OverlapBond>(BondRule::overlap),
    kind<TensionBond>(BondRule::tension),
    kind<RestLengthBond>(BondRule::rest_length),
};

}  // namespace

void BondArrays::resize(std::size_t bonds) {
  pair.resize(bonds);
  for (auto* memory : {&begin, &now}) memory->resize(bonds);
  for (auto* values : {&rate, &rate_now, &slope}) values->resize(bonds);
}

std::span<const BondKind> bond_kinds() noexcept {
  return kinds;
}

const BondKind& bond_kind(BondRule rule) noexcept {
  return *std::find_if(kinds.begin(), kinds.end(), [&](const BondKind& one) { return one.rule == rule; });
}

}  // namespace superstep::dynamics
