#pragma once
/// Spheres in layers along the longest side of their packing: those that touch stand in the same layer or in
/// neighbouring ones, so that processes can share them, and each row finds its neighbours near by.

#include <array>
#include <cstdint>
#include <tuple>

#include "packing/packing.hpp"

namespace superstep {

/// Where a sphere stands: its layer, and where in it.
struct LayerPlace {
  std::int64_t layer = 0, second = 0, third = 0;
  std::int64_t id = 0;  ///< of those in one place the lower one first
  [[nodiscard]] bool operator<(const LayerPlace& other) const noexcept {
    return std::tie(layer, second, third, id) < std::tie(other.layer, other.second, other.third, other.id);
  }
};

class PackingLayers {
 public:
  PackingLayers() = default;
  ///   centres         m, the box around them
  ///   largest_radius  m, > 0
  ///   particles       there are at most as many layers
  PackingLayers(const Bounds& centres, double largest_radius, std::int64_t particles);

  [[nodiscard]] std::int64_t count() const noexcept { return cells_[0]; }
  [[nodiscard]] LayerPlace place_of(Vec3 centre, std::int64_t id) const noexcept;
  /// Least distance [m] of the centres in layers [first, last) from `point`, or less than that.
  [[nodiscard]] double distance(std::int64_t first, std::int64_t last, Vec3 point) const noexcept;

 private:
  Vec3 low_;
  double thickness_ = 1;                        // m
  std::array<char, 3> axes_{'z', 'y', 'x'};     // the longest side first
  std::array<std::int64_t, 3> cells_{1, 1, 1};  // along these
};

/// Puts the spheres in the order of their places, whatever the order of the file was.
void stand_in_layers(Packing& packing);

/// Of so many radii [m] by their sum: one formula for who has all of them and who has some.
[[nodiscard]] constexpr double mean_diameter(double sum_of_radii, std::uint64_t particles) noexcept {
  return 2 * sum_of_radii / static_cast<double>(particles);
}

}  // namespace superstep
