#pragma once
/// Temperatures that a case states, against the ranges of its laws of conductivity.

#include "case/scene.hpp"

namespace superstep {

/// Every start, fixed and ambient temperature within the run must lie in the range of the laws, thermal and
/// electric, of the material that it stands for; laws with outside = "clamp" take any. To be called before
/// the right-hand side is built. Throws InputError.
void require_laws_to_hold(const Scene& scene);

}  // namespace superstep
