#pragma once
/// What a generator can be asked for.

#include <cstddef>

#include "packing/generate.hpp"

namespace superstep {

/// Most spheres that a generated packing may have; more is nearly always a slip in a unit.
inline constexpr std::size_t largest_packing = 100'000'000;
/// Gap, as a fraction of the smaller radius, up to which bonding spheres are drawn together.
inline constexpr double bond_range = 0.5;

/// Throws UsageError that names the setting, its value, the rule and the way out.
void check_pack_settings(const PackSettings& settings);

}  // namespace superstep
