#pragma once
/// Values of nodes that follow those which are here.

#include <span>
#include <vector>

#include "case/layers/layered_scene.hpp"
#include "parallel/communicator.hpp"

namespace superstep {

/// Collective: the values of the nodes from `nodes.end` on that contacts of own nodes can reach; nothing
/// where no node is here.
///   own  [nodes.begin, nodes.end)
[[nodiscard]] std::vector<double> values_beyond(const LayeredNodes& nodes, std::span<const double> own,
                                                Communicator& among);

}  // namespace superstep
