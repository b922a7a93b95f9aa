#pragma once
/// Linear scenes by eigenvectors.

#include "audit/oracle/oracle.hpp"

namespace superstep::audit {

/// Exact but for rounding in extended precision. The scene must be linear.
[[nodiscard]] Truth linear_truth(const StatedScene& scene);

}  // namespace superstep::audit
