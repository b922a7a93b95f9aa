#pragma once
/// Effective conductivity of a packing between two fixed layers.

#include <optional>
#include <string>

#include "scene/scene.hpp"

namespace superstep {

struct EffectiveConductivity {
  std::optional<double> value;  ///< W/(m K) or S/m
  double flow = 0;              ///< W or A, from the higher to the lower value
  double length = 0;            ///< m, between the facing innermost centres of the two layers
  double area = 0;              ///< m^2
  std::string note;             ///< why there is no value, or what was assumed
};

/// k = q L / (A dT) from a steady solve. Needs a packing and exactly two distinct fixed values.
[[nodiscard]] EffectiveConductivity effective_conductivity(const Scene& scene, const FieldScene& field);

}  // namespace superstep
