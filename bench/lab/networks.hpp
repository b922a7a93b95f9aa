#pragma once
/// Networks that the stability laboratory brings along.

#include <cstdint>
#include <memory>
#include <vector>

#include "network/graph.hpp"
#include "rhs/network_rhs.hpp"

namespace superstep {

struct LaboratoryNetwork {
  Graph graph;
  std::unique_ptr<NetworkRhs> rhs;
  std::vector<double> initial;  ///< [free]
};

/// n free nodes in a row between two fixed ends, 0 and 1; capacity and conductance 1; a rough start in [0,
/// 1].
[[nodiscard]] LaboratoryNetwork chain_network(std::size_t free_nodes);

/// A random connected network of particles: radii log-uniform in [1, size_ratio] with both ends present,
/// capacity r^3, conductance min(r_i, r_j) times a factor log-uniform in [1, contrast]. Free nodes start at 0
/// or 1 at random, two nodes are fixed at 0 and 1.
struct RandomNetwork {
  std::size_t nodes = 300;
  double contrast = 1;
  double size_ratio = 1;
  std::uint64_t seed = 1;
};
[[nodiscard]] LaboratoryNetwork random_network(const RandomNetwork& settings);

}  // namespace superstep
