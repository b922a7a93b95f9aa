#pragma once
/// Values of nodes that follow those which are here.

#include <span>
#include <vector>

#include "case/layers/layered_scene.hpp"
#include "parallel/communicator.hpp"

namespace superstep {

/// Nodes behind the last own one that contacts of own nodes can reach.
[[nodiscard]] std::int64_t reach_of_contacts(const Lattice& lattice) noexcept;

/// Collective: the values of so many nodes from `nodes.end` on, as far as there are any; nothing where no
/// node is here.
///   own  [nodes.begin, nodes.end)
[[nodiscard]] std::vector<double> values_beyond(const LayeredNodes& nodes, std::span<const double> own,
                                                Communicator& among);

}  // namespace superstep
