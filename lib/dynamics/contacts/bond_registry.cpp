#include "dynamics/contacts/bond_registry.hpp"

#include <algorithm>
#include <array>

#include "core/index.hpp"
#include "dynamics/contacts/vector_loops.hpp"
#include "dynamics/laws/bonds/overlap_bond.hpp"
#include "dynamics/laws/bonds/rest_length_bond.hpp"
#include "dynamics/laws/bonds/tension_bond.hpp"

namespace superstep::dynamics {
namespace {

using Block = std::array<double, pairs_per_block>;

/// Bonds side by side: what is gathered for them, what they remember, and what they do.
struct BondBlock {
  Block strain, temperature, power, mobility;  // power: |E|^p of the contact, 0 without overlap
  Block area, radius_sum, square_i, square_j, mass, hardness;
  Block overlap, growth, rate;  // as the step began; overlap and growth become those of the instant
  Block rate_now, neck;
  Block keep, pull, damping, flow, slope;
};

void gather(const BondSurroundings& around, const BondArrays& bonds, const ContactTable& table,
            std::size_t first, std::size_t count, BondBlock& b) {
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t k = bonds.pair[first + n];
    const std::size_t i = at(table.i[k]), j = at(table.j[k]);
    b.strain[n] = table.strain[k];
    b.temperature[n] = 0.5 * (around.temperature[i] + around.temperature[j]);
    b.power[n] = strain_power(std::max(-table.strain[k], 0.0), around.contact.exponent);
    b.mobility[n] = around.mobility.empty() ? 1 : around.mobility[i] * around.mobility[j];
    b.area[n] = table.area[k];
    b.radius_sum[n] = table.radius_sum[k];
    b.square_i[n] = table.square[k];
    b.square_j[n] = table.square[k] + table.square_difference[k];
    b.mass[n] = table.reduced_mass[k];
    b.hardness[n] = table.hardness[k];
    b.overlap[n] = bonds.begin[first + n].overlap;
    b.growth[n] = bonds.begin[first + n].growth;
    b.rate[n] = bonds.rate[first + n];
    b.rate_now[n] = b.neck[n] = 0;
  }
}

void scatter(const BondBlock& b, std::size_t first, std::size_t count, BondArrays& bonds,
             ContactTable& table) {
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t k = bonds.pair[first + n];
    bonds.now[first + n] = {b.overlap[n], b.growth[n]};
    bonds.rate_now[first + n] = b.rate_now[n];
    bonds.slope[first + n] = b.slope[n];
    table.keep[k] = b.keep[n];
    table.pull[k] = b.pull[n];
    table.damping[k] = b.damping[n];
    table.flow[k] = b.flow[n];
  }
}

[[gnu::always_inline]] inline BondedPair pair_of(const ContactLaw& contact, const BondBlock& b,
                                                 std::size_t n) noexcept {
  return {.strain = b.strain[n],
          .temperature = b.temperature[n],
          .pressure =
              softened(contact.stiffness, contact.softening, b.temperature[n]) * b.power[n] * b.hardness[n],
          .mobility = b.mobility[n],
          .contact_area = b.area[n],
          .bond_area = circle_area(b.radius_sum[n] * (1 - b.overlap[n]), b.square_i[n], b.square_j[n]),
          .neck = b.neck[n],
          .radius_sum = b.radius_sum[n],
          .reduced_mass = b.mass[n]};
}

/// Largest overlaps and necks of the instant.
template <class Law>
SUPERSTEP_CLONES void remember(const BondSurroundings& around, BondBlock& b, std::size_t count) {
  const BondLaw law = around.law;
  const ContactLaw contact = around.contact;
  const StepPart step = around.step;
  SUPERSTEP_INDEPENDENT
  for (std::size_t n = 0; n < count; ++n) {
    b.overlap[n] = std::max(b.overlap[n], -b.strain[n]);
    if constexpr (Law::grows) {
      b.rate_now[n] = Law::rate(law, pair_of(contact, b, n), {b.overlap[n], b.growth[n]});
      b.growth[n] = grown(b.growth[n], b.rate[n], b.rate_now[n], step.h, step.phi);
    }
  }
}

template <class Law>
SUPERSTEP_CLONES void act_block(const BondSurroundings& around, BondBlock& b, std::size_t count) {
  const BondLaw law = around.law;
  const ContactLaw contact = around.contact;
  SUPERSTEP_INDEPENDENT
  for (std::size_t n = 0; n < count; ++n) {
    const BondAction action = Law::act(law, pair_of(contact, b, n), {b.overlap[n], b.growth[n]});
    b.keep[n] = action.keep;
    b.pull[n] = action.pull;
    b.damping[n] = action.damping;
    b.flow[n] = action.area / (b.radius_sum[n] * (1 + b.strain[n]));
    b.slope[n] = action.slope;
  }
}

template <class Law>
void act(const BondSurroundings& around, BondArrays& bonds, ContactTable& table, std::size_t first,
         std::size_t last) {
  BondBlock b;
  for (std::size_t begin = first; begin < last; begin += pairs_per_block) {
    const std::size_t count = std::min(pairs_per_block, last - begin);
    gather(around, bonds, table, begin, count, b);
    remember<Law>(around, b, count);
    if constexpr (Law::grows)
      for (std::size_t n = 0; n < count; ++n) b.neck[n] = neck_part(around.law.growth, b.growth[n]);
    act_block<Law>(around, b, count);
    scatter(b, begin, count, bonds, table);
  }
}

template <class Law>
bool any_switches(const BondLaw& law, const BondArrays& bonds, const ContactTable& table) {
  std::size_t b = 0;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const bool bonded = b < bonds.size() && bonds.pair[b] == k;
    const double margin = Law::margin(law, table.strain[k], bonded ? bonds.now[b] : BondMemory{}, bonded);
    if (switches(margin, bonded)) return true;
    b += bonded ? 1 : 0;
  }
  return false;
}

template <class Law>
constexpr BondKind kind(BondRule rule) {
  return {rule, Law::name, Law::smooth, Law::grows, &Law::margin, &any_switches<Law>, &act<Law>};
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
