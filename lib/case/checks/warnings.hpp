#pragma once
/// Values outside the ranges that users have, and packings that look wrong: said, never silently accepted.

#include <string>
#include <vector>

#include "case/materials.hpp"
#include "case/read_field.hpp"
#include "case/scene.hpp"

namespace superstep {

/// Appends those of `more` that are not said yet: several fields find the same about a material.
void add_warnings(const std::vector<std::string>& more, std::vector<std::string>& all);

/// One sentence per finding; empty for a healthy scene.
[[nodiscard]] std::vector<std::string> range_warnings(const Scene& scene);

/// What the same says of particles, for who does not have them all.
struct PackingFacts {
  double smallest_radius = 0, largest_radius = 0;  ///< m
  std::size_t particles = 0, contacts = 0, limited_necks = 0;
};
[[nodiscard]] std::vector<std::string> packing_warnings(const PackingFacts& facts);

/// Why the sizes of a scene's particles are almost surely a slip in the unit of length, and which unit is
/// likely; empty for sizes from 10 nm to 1 m and for scenes without particles.
[[nodiscard]] std::string implausible_sizes(const Scene& scene);

/// The same for densities, capacities, conductivities and grain boundaries of one field.
[[nodiscard]] std::vector<std::string> material_warnings(const FieldKind& kind, const FieldMaterials& field,
                                                         const Materials& materials);

}  // namespace superstep
