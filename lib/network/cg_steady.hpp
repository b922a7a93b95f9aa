#pragma once
/// Steady values of a network by conjugate gradients: no factorization, any size.

#include <vector>

#include "network/network.hpp"

namespace superstep {

/// Solution x [n] of K x = (what sources and ghosts bring in), with the diagonal as preconditioner, to a
/// residual of `tolerance` times the load's. Parts without a fixed value stay at 0 when nothing acts on them;
/// where something does there is no steady state, and nothing is returned.
[[nodiscard]] std::vector<double> approximate_steady_state(const Network& network, double tolerance);

}  // namespace superstep
