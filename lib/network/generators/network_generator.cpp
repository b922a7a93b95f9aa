#include "network/generators/network_generator.hpp"

#include "core/hash.hpp"

// One line per generator: its file in this folder defines `NetworkGenerator NAME_generator()`.
#define SUPERSTEP_GENERATORS(generator)                                                    \
  generator(ladder) generator(tree) generator(rings) generator(lattice) generator(mixture) \
      generator(spheres) generator(fibres) generator(hubs) generator(pores)

namespace superstep {

#define SUPERSTEP_DECLARE(name) NetworkGenerator name##_generator();
SUPERSTEP_GENERATORS(SUPERSTEP_DECLARE)
#undef SUPERSTEP_DECLARE

std::span<const NetworkGenerator> network_generators() {
#define SUPERSTEP_ENTRY(name) name##_generator(),
  static const std::vector<NetworkGenerator> table = {SUPERSTEP_GENERATORS(SUPERSTEP_ENTRY)};
#undef SUPERSTEP_ENTRY
  return table;
}

const NetworkGenerator* find_network_generator(const std::string& name) {
  for (const auto& entry : network_generators())
    if (entry.name == name) return &entry;
  return nullptr;
}

std::string network_hash(const GeneratedNetwork& network) {
  ContentHash hash;
  const Graph& graph = network.graph;
  hash.add_all<double>(graph.capacity).add_all<double>(graph.conductance);
  for (const auto* nodes : {&graph.i, &graph.j, &network.inlet, &network.outlet, &network.heated})
    hash.add_all<std::int32_t>(*nodes);
  return hash.text();
}

}  // namespace superstep
