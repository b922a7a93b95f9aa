#pragma once
/// Connected components of a scene that nobody has as a whole.

#include <cstdint>
#include <utility>
#include <vector>

#include "case/component_facts.hpp"
#include "case/layers/layered_scene.hpp"
#include "network/disjoint_sets.hpp"

namespace superstep {

class LayerClusters {
 public:
  /// Of a process that has nodes [begin, end).
  LayerClusters(std::int64_t begin, std::int64_t end);

  /// Takes the own ones of nodes [first, last), and the contacts that are theirs.
  void take(const ReadLayers& read, std::int64_t first, std::int64_t last);
  /// Collective, once all own nodes are there: components of the whole scene without a fixed node that
  /// exchange nothing with an ambient and in which something happens, or all of these where nothing happens
  /// anywhere.
  [[nodiscard]] std::uint64_t count_adrift(Communicator& among) &&;

 private:
  struct Contact {
    std::int64_t i, j;
  };
  struct Cluster {
    std::int64_t root;  // a node
    ComponentFacts facts;
  };
  [[nodiscard]] std::int64_t root_of(std::int64_t node) {
    return begin_ + sets_.root(static_cast<std::uint32_t>(node - begin_));
  }
  [[nodiscard]] std::vector<Contact> name_by_roots(Communicator& among);

  std::int64_t begin_, end_;
  DisjointSets sets_;
  std::vector<ComponentFacts> facts_;  // [own nodes], of the node alone until they are counted
  std::vector<Contact> beyond_;        // with nodes of others
};

}  // namespace superstep
