#pragma once
/// Connected components: which nodes can exchange anything at all.

#include <cstdint>
#include <span>
#include <vector>

namespace superstep {

struct Components {
  std::vector<std::int32_t> of_node;  ///< [n] component of each node, numbered by first appearance
  std::size_t count = 0;
};

/// Components of the graph with edges (i[k], j[k]); an edge of conductance 0 joins nothing. Near-linear time.
[[nodiscard]] Components connected_components(std::size_t nodes, std::span<const std::int32_t> i,
                                              std::span<const std::int32_t> j,
                                              std::span<const double> conductance);

}  // namespace superstep
