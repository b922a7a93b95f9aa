#include "dynamics/walls.hpp"

#include <algorithm>

namespace superstep::dynamics {

const char* wall_name(Wall wall) noexcept {
  constexpr std::array<const char*, wall_count> names = {"-x", "+x", "-y", "+y", "lower", "upper"};
  return names[static_cast<std::size_t>(wall)];
}

Vec3 outward(Wall wall) noexcept {
  constexpr std::array<Vec3, wall_count> normals = {
      {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};
  return normals[static_cast<std::size_t>(wall)];
}

double wall_distance(const Box& box, double upper_wall, Wall wall, Vec3 point) noexcept {
  switch (wall) {
    case left_x:
      return point.x - box.min.x;
    case right_x:
      return box.max.x - point.x;
    case left_y:
      return point.y - box.min.y;
    case right_y:
      return box.max.y - point.y;
    case lower:
      return point.z - box.min.z;
    default:
      return upper_wall - point.z;
  }
}

void find_wall_contacts(const Box& box, double upper_wall, std::span<const Vec3> position,
                        std::span<const double> radius, std::vector<WallContact>& contacts) {
  contacts.clear();
  for (std::size_t i = 0; i < position.size(); ++i) {
    const double r = radius[i];
    const Vec3& p = position[i];
    const double nearest = std::min({p.x - box.min.x, box.max.x - p.x, p.y - box.min.y, box.max.y - p.y,
                                     p.z - box.min.z, upper_wall - p.z});
    if (nearest >= r) continue;  // most; what is no number is looked at wall by wall
    for (std::int32_t w = 0; w < wall_count; ++w) {
      const auto wall = static_cast<Wall>(w);
      const double distance = wall_distance(box, upper_wall, wall, position[i]);
      if (!(distance < r)) continue;
      const double inside = std::max(distance, 0.0);
      contacts.push_back({static_cast<std::int32_t>(i), wall, (distance - r) / r,
                          std::numbers::pi * (r * r - inside * inside), distance});
    }
  }
}

}  // namespace superstep::dynamics
