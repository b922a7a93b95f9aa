#pragma once
/// A packing of spheres: what every network is built from.

#include <cstdint>
#include <string>
#include <vector>

#include "core/vec3.hpp"

namespace superstep {

/// n spheres, structure of arrays, SI units.
struct Packing {
  std::vector<std::int64_t> id;        ///< [n] the user's ids, unique; 0, 1, 2, ... where the file has none
  std::vector<Vec3> centre;            ///< [n] m
  std::vector<double> radius;          ///< [n] m, > 0
  std::vector<std::int32_t> material;  ///< [n] index into material_names; all 0 where the file names none
  std::vector<std::string> material_names;  ///< empty where the file names none
  std::string frame;  ///< which of the frames of its file this is, in words; empty where there is one

  [[nodiscard]] std::size_t size() const noexcept { return radius.size(); }
};

/// Axis-aligned box around points or spheres [m].
struct Bounds {
  Vec3 min, max;
};

/// Box around the surfaces of all spheres. The packing must not be empty.
[[nodiscard]] Bounds surface_bounds(const Packing& packing);

/// Sum of the sphere volumes [m^3]; overlaps count twice, as in the relative density of the source paper.
[[nodiscard]] double sphere_volume(const Packing& packing);

}  // namespace superstep
