#pragma once
/// The order in which the entries of a chunk are added up.

#include <array>
#include <cstddef>

namespace superstep {

/// Running sums, taken in turn: they let vector registers be used without changing the order from run to run.
inline constexpr std::size_t sum_lanes = 8;

[[nodiscard]] constexpr double sum_of_lanes(const std::array<double, sum_lanes>& s) noexcept {
  return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
}

}  // namespace superstep
