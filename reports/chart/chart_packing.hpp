#pragma once
/// Pictures of the packing: a cut through the middle, spheres coloured by a field.

#include <string>

#include "results/observations.hpp"

namespace superstep {

/// One small picture per time of every field, on one colour scale per field; empty without frames.
///   id  prefix of the figures' ids
[[nodiscard]] std::string packing_figures(const Slice& slice, const std::string& id);

}  // namespace superstep
