/// Spheres near the sides get copies on the other side; pairs are then sought as in open space.
///
///      copy |             | sphere     What reaches across a side meets a copy of what lies at the opposite
///      one. Of a
///        o  | o         o | o          pair that is found from both of its ends one is kept.

#include "packing/periodic_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/error.hpp"
#include "packing/near_pairs.hpp"

namespace superstep {
namespace {

using Image = std::array<std::int8_t, 3>;

/// A sphere or a copy of one.
struct Copies {
  std::vector<Vec3> centre;
  std::vector<double> radius;
  std::vector<std::int32_t> of;
  std::vector<Image> image;
};

/// How many copies along each edge can be near anything inside.
std::array<int, 3> image_range(const Cell& cell, double reach) {
  std::array<int, 3> range{};
  constexpr double most = 100;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!cell.periodic[axis]) continue;
    const double images = std::ceil(reach / cell.height(axis));
    if (!(images <= most))
      throw InputError(fmt::format(
          "the periodic cell is {} m high along {}, and spheres reach {} m: it is too thin; check "
          "its bounds and the length unit",
          cell.height(axis), "xyz"[axis], reach));
    range[axis] = static_cast<int>(images);
  }
  return range;
}

Copies copies_near_sides(std::span<const Vec3> centres, std::span<const double> radii, double gap,
                         const Cell& cell) {
  const double largest = *std::max_element(radii.begin(), radii.end());
  const auto range = image_range(cell, 2 * largest + gap);
  const std::array<double, 3> height = {cell.height(0), cell.height(1), cell.height(2)};
  Copies out;
  out.centre.assign(centres.begin(), centres.end());
  out.radius.assign(radii.begin(), radii.end());
  for (std::size_t k = 0; k < radii.size(); ++k) out.of.push_back(static_cast<std::int32_t>(k));
  out.image.assign(radii.size(), Image{});
  for (std::size_t k = 0; k < radii.size(); ++k) {
    const Vec3 part = cell.fraction(centres[k]);
    const double reach = radii[k] + largest + gap;
    const auto is_near = [&](std::size_t axis, int image) {
      const double at = (axis == 0 ? part.x : axis == 1 ? part.y : part.z) + image;
      return !cell.periodic[axis] || height[axis] * std::max(-at, at - 1) < reach;
    };
    for (int a = -range[0]; a <= range[0]; ++a) {
      if (!is_near(0, a)) continue;
      for (int b = -range[1]; b <= range[1]; ++b) {
        if (!is_near(1, b)) continue;
        for (int c = -range[2]; c <= range[2]; ++c) {
          if (!is_near(2, c) || (a == 0 && b == 0 && c == 0)) continue;
          out.centre.push_back(centres[k] + cell.shift({a, b, c}));
          out.radius.push_back(radii[k]);
          out.of.push_back(static_cast<std::int32_t>(k));
          out.image.push_back(
              {static_cast<std::int8_t>(a), static_cast<std::int8_t>(b), static_cast<std::int8_t>(c)});
        }
      }
    }
  }
  return out;
}

}  // namespace

std::vector<ImagePair> periodic_pairs(std::span<const Vec3> centres, std::span<const double> radii,
                                      double gap, const Cell& cell) {
  if (radii.empty()) return {};
  const Copies all = copies_near_sides(centres, radii, gap, cell);
  const auto spheres = static_cast<std::int32_t>(radii.size());
  std::vector<ImagePair> out;
  for (const auto [first, second] : near_pairs(all.centre, all.radius, gap)) {
    if (first >= spheres) break;  // sorted: from here on copies meet copies
    const auto k = static_cast<std::size_t>(second);
    const std::int32_t j = all.of[k];
    // A pair across a side is found from both ends, and a sphere meets both of two opposite images of its
    // own.
    if (first < j || (first == j && all.image[k] > Image{})) out.push_back({first, j, all.image[k]});
  }
  std::sort(out.begin(), out.end(), [](const ImagePair& a, const ImagePair& b) {
    return std::tie(a.i, a.j, a.image) < std::tie(b.i, b.j, b.image);
  });
  return out;
}

}  // namespace superstep
