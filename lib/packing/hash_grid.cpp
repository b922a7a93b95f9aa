#include "packing/hash_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace superstep {
namespace {

/// Cell coordinate of a position measured in cells; what is too far for an integer shares the last cell.
std::int64_t cell_coordinate(double position) noexcept {
  constexpr double limit = 4e18;
  return static_cast<std::int64_t>(std::floor(std::clamp(position, -limit, limit)));
}

}  // namespace

HashGrid::HashGrid(std::span<const GridEntry> members, double cell_width)
    : cell_width_(cell_width), mask_(std::bit_ceil(2 * members.size() + 1) - 1), entries_(members.size()) {
  start_.assign(mask_ + 2, 0);
  std::vector<std::size_t> bucket(members.size());
  for (std::size_t k = 0; k < members.size(); ++k) {
    bucket[k] = bucket_of(cell_of(members[k].centre));
    ++start_[bucket[k] + 1];
  }
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  auto next = start_;
  for (std::size_t k = 0; k < members.size(); ++k) entries_[next[bucket[k]]++] = members[k];
}

std::pair<std::int64_t, std::int64_t> HashGrid::range(double coordinate, double reach) const noexcept {
  const double position = coordinate / cell_width_;
  const double rounding =
      1e-9 + std::min(1.0, 1e-15 * std::abs(position));  // must not hide a touching sphere
  const double width = reach / cell_width_ + rounding;
  return {cell_coordinate(position - width), cell_coordinate(position + width)};
}

HashGrid::Cell HashGrid::cell_of(Vec3 centre) const noexcept {
  return {cell_coordinate(centre.x / cell_width_), cell_coordinate(centre.y / cell_width_),
          cell_coordinate(centre.z / cell_width_)};
}

std::size_t HashGrid::bucket_of(const Cell& cell) const noexcept {
  constexpr std::uint64_t row = 0x9E3779B97F4A7C15u, layer = 0xC2B2AE3D27D4EB4Fu;  // any large odd numbers
  const std::uint64_t hash =
      static_cast<std::uint64_t>(cell.y) * row ^ static_cast<std::uint64_t>(cell.z) * layer;
  constexpr int low_bits_mix_badly = 24;
  return static_cast<std::size_t>((hash >> low_bits_mix_badly) + static_cast<std::uint64_t>(cell.x)) & mask_;
}

}  // namespace superstep
