#pragma once
/// Free nodes that are connected with each other.

#include <cstdint>
#include <vector>

#include "network/graph.hpp"

namespace superstep::audit {

/// [nodes] the part that a free node belongs to, -1 of fixed nodes; how many parts there are.
[[nodiscard]] std::vector<std::int32_t> parts_of_nodes(const Graph& graph, std::int32_t& count);

}  // namespace superstep::audit
