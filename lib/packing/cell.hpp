#pragma once
/// The box that a packing lies in: a parallelepiped, open or periodic along each of its edges.

#include <array>
#include <string>

#include "core/vec3.hpp"

namespace superstep {

struct Cell {
  Vec3 origin;                     ///< m; a corner
  std::array<Vec3, 3> edge{};      ///< m; right-handed or not, of volume > 0
  std::array<bool, 3> periodic{};  ///< along each edge: what leaves on one side enters on the other

  [[nodiscard]] bool is_periodic() const noexcept { return periodic[0] || periodic[1] || periodic[2]; }
  [[nodiscard]] double volume() const noexcept;  ///< m^3, >= 0
  /// Distance between the two faces that edge k leads across [m].
  [[nodiscard]] double height(std::size_t k) const noexcept;
  /// Vector of so many edges [m].
  [[nodiscard]] Vec3 shift(const std::array<int, 3>& edges) const noexcept;
  /// Where a point lies, in parts of the edges: 0 to 1 inside.
  [[nodiscard]] Vec3 fraction(Vec3 point) const noexcept;
  /// The point of such parts [m].
  [[nodiscard]] Vec3 point(Vec3 fraction) const noexcept;
  /// The image of a point that lies inside along every periodic edge.
  [[nodiscard]] Vec3 wrapped(Vec3 point) const noexcept;
  /// Names of the periodic edges, as in "xy"; "none" without any.
  [[nodiscard]] std::string periodic_axes() const;
};

/// The box between two corners, open along every edge.
[[nodiscard]] Cell box_cell(Vec3 low, Vec3 high) noexcept;

/// Vector product.
[[nodiscard]] constexpr Vec3 cross(Vec3 a, Vec3 b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace superstep
