/// A hierarchy of grids, one per size class (radii within a factor of two). The cells of a class are as wide
/// as its largest sphere; each sphere looks in its own class and in the coarser ones.
///
///   class 0  |       O       |       O       |     Every sphere meets a bounded number of cells per class,
///   class 1  |   o   |       |   o   |   o   |     and a bounded number of spheres per cell,
///   class 2  | . | . |   | . |   | . | . |   |     however different the radii are.

#include "packing/near_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "packing/hash_grid.hpp"

namespace superstep {
namespace {

struct SizeClass {
  HashGrid grid;
  double largest;  // radius [m]
};

/// Power of two that the radius lies in: one size class each.
int size_of(double radius) noexcept {
  return std::ilogb(radius);
}

/// All spheres, neighbours in space mostly side by side in memory: what a sphere looks at is still in the
/// cache from the one before.
std::vector<GridEntry> in_spatial_order(std::span<const Vec3> centres, std::span<const double> radii) {
  std::vector<GridEntry> spheres(radii.size());
  for (std::size_t k = 0; k < radii.size(); ++k)
    spheres[k] = {centres[k], radii[k], static_cast<std::int32_t>(k)};
  const double mean = std::accumulate(radii.begin(), radii.end(), 0.0) / static_cast<double>(radii.size());
  constexpr double diameters_per_block = 16.0;  // 8 to 32 measured alike, 4 and no blocks at all slower
  const HashGrid blocks(spheres, diameters_per_block * 2.0 * mean);
  return {blocks.entries().begin(), blocks.entries().end()};
}

/// The size classes that have members, coarse to fine.
std::vector<SizeClass> size_classes(std::span<const GridEntry> spheres, double gap) {
  const auto [smallest, largest] =
      std::minmax_element(spheres.begin(), spheres.end(),
                          [](const GridEntry& a, const GridEntry& b) { return a.radius < b.radius; });
  std::vector<std::vector<GridEntry>> members(
      static_cast<std::size_t>(size_of(largest->radius) - size_of(smallest->radius) + 1));
  for (const auto& sphere : spheres)
    members[static_cast<std::size_t>(size_of(largest->radius) - size_of(sphere.radius))].push_back(sphere);
  std::vector<SizeClass> classes;
  for (const auto& alike : members) {
    double radius = 0;
    for (const auto& sphere : alike) radius = std::max(radius, sphere.radius);
    if (!alike.empty()) classes.push_back({HashGrid(alike, 2.0 * radius + gap), radius});
  }
  return classes;
}

bool is_near(const GridEntry& a, const GridEntry& b, double gap) noexcept {
  constexpr double rounding = 1.0 + 2e-12;
  const Vec3 between = a.centre - b.centre;
  const double limit = a.radius + b.radius + gap;
  return dot(between, between) < rounding * limit * limit;
}

/// Counting sort by i, then each short list of partners by j.
std::vector<NearPair> sorted(const std::vector<NearPair>& pairs, std::size_t count) {
  std::vector<std::size_t> start(count + 1, 0);
  for (const auto& pair : pairs) ++start[static_cast<std::size_t>(pair.i) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  auto next = start;
  std::vector<NearPair> out(pairs.size());
  for (const auto& pair : pairs) out[next[static_cast<std::size_t>(pair.i)]++] = pair;
  for (std::size_t i = 0; i < count; ++i)
    std::sort(out.begin() + static_cast<std::ptrdiff_t>(start[i]),
              out.begin() + static_cast<std::ptrdiff_t>(start[i + 1]),
              [](const NearPair& a, const NearPair& b) { return a.j < b.j; });
  return out;
}

}  // namespace

std::vector<NearPair> near_pairs(std::span<const Vec3> centres, std::span<const double> radii, double gap,
                                 std::size_t* candidates) {
  if (radii.empty()) return {};
  const auto spheres = in_spatial_order(centres, radii);
  const auto classes = size_classes(spheres, gap);
  std::vector<NearPair> pairs;
  std::size_t looked_at = 0;
  for (const GridEntry& sphere : spheres)
    for (const auto& [grid, largest] : classes) {
      const bool own_class = size_of(sphere.radius) == size_of(largest);
      const auto accept = [&](const GridEntry& other) { return is_near(sphere, other, gap); };
      const auto keep = [&](const GridEntry& other, bool together) {
        if (own_class && together && sphere.index >= other.index) return;  // both see each other, and itself
        pairs.push_back({std::min(sphere.index, other.index), std::max(sphere.index, other.index)});
      };
      const auto cells = own_class ? HashGrid::Cells::not_before : HashGrid::Cells::all;
      looked_at += grid.near(sphere.centre, sphere.radius + largest + gap, cells, accept, keep);
      if (own_class) break;  // the finer classes look here themselves
    }
  if (candidates != nullptr) *candidates = looked_at;
  return sorted(pairs, radii.size());
}

}  // namespace superstep
