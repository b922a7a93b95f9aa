#pragma once
/// A packing of spheres: what every network is built from.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/vec3.hpp"
#include "packing/cell.hpp"

namespace superstep {

/// A column of the file that says more of each particle than where it is, in the file's own units.
struct PackingAttribute {
  std::string name;           ///< as the file writes it
  std::vector<double> value;  ///< [n]; NaN where the file has no number
};

/// Axis-aligned box around points or spheres [m].
struct Bounds {
  Vec3 min, max;
  /// Takes in a box between two corners.
  void take(Vec3 low, Vec3 high) noexcept {
    min = {std::min(min.x, low.x), std::min(min.y, low.y), std::min(min.z, low.z)};
    max = {std::max(max.x, high.x), std::max(max.y, high.y), std::max(max.z, high.z)};
  }
};

/// What a packing is a part of, where others have the rest.
struct PackingPart {
  Bounds bounds;               ///< m, around the surfaces of all spheres
  std::int64_t particles = 0;  ///< all there are
  bool ids_count = true;       ///< their ids are 0, 1, 2, ...; else others have some that nobody here knows
};

/// n spheres, structure of arrays, SI units.
struct Packing {
  std::vector<std::int64_t> id;        ///< [n] the user's ids, unique; 0, 1, 2, ... where the file has none
  std::vector<Vec3> centre;            ///< [n] m
  std::vector<double> radius;          ///< [n] m, > 0
  std::vector<std::int32_t> material;  ///< [n] index into material_names; all 0 where the file names none
  std::vector<std::string> material_names;  ///< empty where the file names none
  std::string single_type;    ///< the one type of all, where a number that all have is no material by itself
  std::string place;          ///< file that it was read from; empty for none
  std::string columns_place;  ///< "file:line" where its columns are named, or the file; empty for none
  std::string frame;          ///< which of the frames of its file this is, in words; empty where there is one
  std::vector<PackingAttribute> attributes;  ///< in the order of the file
  std::vector<std::string> text_columns;     ///< left out, since they hold text
  std::optional<Cell> cell;                  ///< m; the box that the file or the user states
  double length_unit = 1;                    ///< m; of the lengths in the file
  std::string unit_style;                    ///< that the file is in, as in "micro"; empty = it says none
  std::string format;                        ///< what the file is, in words; empty for a packing from no file
  std::vector<std::string> notes;            ///< how the file was understood
  std::vector<std::string> warnings;         ///< what its user should look at
  bool in_order = false;  ///< spheres that touch stand near each other: nobody need look for a better order
  std::optional<PackingPart> part_of;  ///< where others have the rest of it
  std::optional<double>
      mean_diameter;  ///< m, of all spheres, where it must not hang on how they are added up

  [[nodiscard]] std::size_t size() const noexcept { return radius.size(); }
};

/// The attribute of that name, or of one that differs in case or has a unit behind it; nullptr where there is
/// none. Throws InputError where several are as good.
[[nodiscard]] const PackingAttribute* find_attribute(const Packing& packing, const std::string& name);

/// Box around the surfaces of all spheres, those that others have included. The packing must not be empty.
[[nodiscard]] Bounds surface_bounds(const Packing& packing);

/// Sum of the sphere volumes [m^3]; overlaps count twice, as in the relative density of the source paper.
[[nodiscard]] double sphere_volume(const Packing& packing);

}  // namespace superstep
