#pragma once
/// A network whose order is known already.

#include <cstdint>
#include <span>

#include "network/network.hpp"

namespace superstep {

/// What `build_network` builds, with rows in a given order: that of nearly the same network serves as well,
/// and finding another would cost more than the rest.
///   nodes  positions in the graph; every free node stands there once, others are passed over
[[nodiscard]] Network build_network_in_order(const Graph& graph, std::span<const NodeRole> roles,
                                             double origin, std::span<const std::int32_t> nodes);

}  // namespace superstep
