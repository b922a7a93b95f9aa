#pragma once
/// Rough answers about a graph, so that what heats it can be given a size: slow, dense and simple.

#include <vector>

#include "network/graph.hpp"
#include "rhs/kernels/variable_conduction.hpp"

namespace superstep::audit {

/// Bound of the spectral radius of C^-1 K with conductances as they stand [1/s]; radiation counts with its
/// slope at `hottest` [K].
[[nodiscard]] double radius_bound(const Graph& graph, double hottest);

/// Largest rise [K] after `duration` that constant heat [nodes, W] causes in a graph at rest, some 20 % low.
[[nodiscard]] double rise_of(const Graph& graph, const std::vector<double>& heat, double duration);

/// Joule heat of the nodes [W] in the steady potential of the given fixed values and sources [nodes].
[[nodiscard]] std::vector<double> steady_joule_heat(const Graph& electric, const ConductionLaws& laws,
                                                    const std::vector<double>& fixed,
                                                    const std::vector<double>& source);

}  // namespace superstep::audit
