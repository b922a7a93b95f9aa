#pragma once
/// Graphs of many shapes: which nodes are joined, and nothing else.

#include <cstdint>
#include <string>
#include <vector>

#include "core/random.hpp"

namespace superstep::audit {

struct Wiring {
  std::string shape;
  std::int32_t nodes = 0;
  std::vector<std::int32_t> i, j;       ///< [edges] no pair twice
  std::vector<std::int32_t> component;  ///< [nodes] number of the connected piece
};

/// About `nodes` nodes, at least 3.
[[nodiscard]] Wiring random_wiring(Random& random, std::int32_t nodes);

}  // namespace superstep::audit
