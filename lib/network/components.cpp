#include "network/components.hpp"

#include "network/disjoint_sets.hpp"

namespace superstep {

Components connected_components(std::size_t nodes, std::span<const std::int32_t> i,
                                std::span<const std::int32_t> j, std::span<const double> conductance) {
  DisjointSets sets(nodes);
  for (std::size_t k = 0; k < i.size(); ++k)
    if (conductance[k] > 0) sets.join(static_cast<std::uint32_t>(i[k]), static_cast<std::uint32_t>(j[k]));
  Components out;
  out.of_node.resize(nodes);
  constexpr std::int32_t unseen = -1;
  std::vector<std::int32_t> number(nodes, unseen);
  for (std::size_t node = 0; node < nodes; ++node) {
    auto& component = number[sets.root(static_cast<std::uint32_t>(node))];
    if (component == unseen) component = static_cast<std::int32_t>(out.count++);
    out.of_node[node] = component;
  }
  return out;
}

}  // namespace superstep
