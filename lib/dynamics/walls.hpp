#pragma once
/// The six walls of the press: a box whose upper wall moves.

#include <array>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "core/vec3.hpp"
#include "dynamics/laws/schedule.hpp"
#include "dynamics/particles.hpp"

namespace superstep::dynamics {

/// Numbers of the walls.
enum Wall : std::int32_t { left_x, right_x, left_y, right_y, lower, upper, wall_count };
[[nodiscard]] const char* wall_name(Wall wall) noexcept;

struct Box {
  Vec3 min, max;  ///< m; max.z is where the upper wall starts
};

/// A particle that touches a wall.
struct WallContact {
  std::int32_t particle;
  Wall wall;
  double strain;    ///< E_w = (distance - r)/r < 0
  double area;      ///< m2
  double distance;  ///< of the centre from the wall [m]
};

/// Direction from the inside onto a wall.
[[nodiscard]] Vec3 outward(Wall wall) noexcept;

/// Distance of a point from a wall of the box with its upper wall at `upper_wall` [m]; negative outside.
[[nodiscard]] double wall_distance(const Box& box, double upper_wall, Wall wall, Vec3 point) noexcept;

/// All wall contacts, by particle and then by wall, into `contacts` (its memory is reused).
/// A centre on a wall or beyond has the largest area there is, pi r^2: the force does not let go.
void find_wall_contacts(const Box& box, double upper_wall, std::span<const Vec3> position,
                        std::span<const double> radius, std::vector<WallContact>& contacts);

}  // namespace superstep::dynamics
