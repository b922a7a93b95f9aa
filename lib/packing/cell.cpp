#include "packing/cell.hpp"

#include <cmath>

namespace superstep {
namespace {

double part_inside(double part) noexcept {
  const double inside = part - std::floor(part);
  return inside < 1 ? inside : 0.0;  // a tiny negative part rounds to a whole edge
}

}  // namespace

double Cell::volume() const noexcept {
  return std::abs(dot(edge[0], cross(edge[1], edge[2])));
}

double Cell::height(std::size_t k) const noexcept {
  return volume() / norm(cross(edge[(k + 1) % 3], edge[(k + 2) % 3]));
}

Vec3 Cell::shift(const std::array<int, 3>& edges) const noexcept {
  return edges[0] * edge[0] + edges[1] * edge[1] + edges[2] * edge[2];
}

Vec3 Cell::fraction(Vec3 point) const noexcept {
  const Vec3 from = point - origin;
  const double volume_signed = dot(edge[0], cross(edge[1], edge[2]));
  const auto part = [&](std::size_t k) {
    return dot(from, cross(edge[(k + 1) % 3], edge[(k + 2) % 3])) / volume_signed;
  };
  return {part(0), part(1), part(2)};
}

Vec3 Cell::point(Vec3 fraction) const noexcept {
  return origin + fraction.x * edge[0] + fraction.y * edge[1] + fraction.z * edge[2];
}

Vec3 Cell::wrapped(Vec3 point) const noexcept {
  const Vec3 part = fraction(point);
  const auto steps = [&](std::size_t k, double value) {
    return periodic[k] ? part_inside(value) - value : 0.0;  // exactly 0 for what lies inside already
  };
  return point + steps(0, part.x) * edge[0] + steps(1, part.y) * edge[1] + steps(2, part.z) * edge[2];
}

std::string Cell::periodic_axes() const {
  std::string out;
  for (std::size_t k = 0; k < 3; ++k)
    if (periodic[k]) out += "xyz"[k];
  return out.empty() ? "none" : out;
}

Cell box_cell(Vec3 low, Vec3 high) noexcept {
  const Vec3 size = high - low;
  return {
      .origin = low, .edge = {Vec3{size.x, 0, 0}, Vec3{0, size.y, 0}, Vec3{0, 0, size.z}}, .periodic = {}};
}

}  // namespace superstep
