#pragma once
/// Spheres in memory as a packing.

#include <string>

#include "case/memory/case_data.hpp"
#include "packing/read_options.hpp"

namespace superstep {

/// Checks what `read_packing` checks. Throws InputError that begins with `name`.
[[nodiscard]] Packing packing_of(const SphereArrays& arrays, const std::string& name,
                                 const PackingOptions& options);

}  // namespace superstep
