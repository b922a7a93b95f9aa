#pragma once
/// Networks made by a seed, the same bits with every compiler on every machine: nothing but + - * / and sqrt
/// of doubles, random numbers of our own, and no contraction to fused multiply-adds (see CMakeLists.txt).

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "network/graph.hpp"

namespace superstep {

/// Nodes that a generated network may have.
inline constexpr std::size_t largest_generated_network = 20'000'000;

/// What every generator takes; each says what it makes of them.
struct NetworkRecipe {
  std::size_t size = 0;  ///< nodes wanted, >= 8; a generator may round it to what its shape allows
  double contrast = 1;   ///< largest over smallest conductance, or nearly, >= 1
  double spread = 1;     ///< largest over smallest capacity, or nearly, >= 1
  double fraction = 0;   ///< 0 to 1; what it is a fraction of differs
  std::uint64_t seed = 1;
};

/// A graph without values, and the nodes that a case can name. Conductances begin at 1 W/K and capacities at
/// 1 J/K.
struct GeneratedNetwork {
  Graph graph;
  std::vector<std::int32_t> inlet, outlet;  ///< where values may be fixed: two ends of the network
  std::vector<std::int32_t> heated;         ///< where a source may act
};

/// One line of the table of generators.
struct NetworkGenerator {
  std::string name;
  std::string makes;     ///< one line
  std::string fraction;  ///< what the fraction means; empty: it must be 0
  GeneratedNetwork (*make)(const NetworkRecipe& recipe);
};

[[nodiscard]] std::span<const NetworkGenerator> network_generators();
/// Null when there is none of that name.
[[nodiscard]] const NetworkGenerator* find_network_generator(const std::string& name);

/// 32 hexadecimal digits over capacities, edges, conductances and the named nodes.
[[nodiscard]] std::string network_hash(const GeneratedNetwork& network);

}  // namespace superstep
