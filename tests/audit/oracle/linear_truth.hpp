#pragma once
/// Linear scenes by eigenvectors.

#include "audit/oracle/oracle.hpp"

namespace superstep::audit {

/// Exact but for rounding in extended precision. The scene must be linear.
[[nodiscard]] Truth linear_truth(const StatedScene& scene);
/// The same with sixty digits. Throws std::runtime_error where the tests were built without Boost.
[[nodiscard]] Truth linear_truth_in_sixty_digits(const StatedScene& scene);

}  // namespace superstep::audit
