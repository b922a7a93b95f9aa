#pragma once
/// SUNDIALS' vectors over entries of a state: sums and norms are those of the state's reduction, so that what
/// CVODE decides has the same bits for any number of threads and of processes.

#include <sundials/sundials_nvector.h>

#include <span>

#include "parallel/reduction.hpp"

namespace superstep::sundials {

/// A vector of the reduction's own entries, 0 at first; null where memory is short. The reduction must
/// outlive it and its clones.
[[nodiscard]] N_Vector new_state_vector(const Reduction& reduction, SUNContext context) noexcept;

/// Its entries that are here.
[[nodiscard]] std::span<double> entries(N_Vector v) noexcept;

}  // namespace superstep::sundials
