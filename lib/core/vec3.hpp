#pragma once
/// A point or direction in space.

#include <cmath>

namespace superstep {

struct Vec3 {
  double x = 0, y = 0, z = 0;
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) noexcept {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vec3 operator-(Vec3 a, Vec3 b) noexcept {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vec3 operator*(double s, Vec3 a) noexcept {
  return {s * a.x, s * a.y, s * a.z};
}
constexpr double dot(Vec3 a, Vec3 b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// Along an axis, 'x', 'y' or 'z'.
constexpr double component(Vec3 v, char axis) noexcept {
  return axis == 'x' ? v.x : axis == 'y' ? v.y : v.z;
}
inline double norm(Vec3 a) noexcept {
  return std::sqrt(dot(a, a));
}

}  // namespace superstep
