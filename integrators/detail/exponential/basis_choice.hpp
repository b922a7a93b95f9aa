#pragma once
/// Which basis of the matrix exponential suits a scene.

#include <string>

#include "integrators/costs/work.hpp"

namespace superstep {

struct BasisChoice {
  std::string basis;   ///< "chebyshev", "lanczos" or "shift-invert"
  std::string reason;  ///< as in "lanczos, because it costs the work of about 190 sweeps; chebyshev ..."
};

/// By predicted costs, of a scene with one field.
[[nodiscard]] BasisChoice choose_basis(const Work& work, double rtol);

}  // namespace superstep
