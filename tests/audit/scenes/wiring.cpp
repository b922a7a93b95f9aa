#include "audit/scenes/wiring.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace superstep::audit {
namespace {

/// Collects edges and keeps each pair once.
class Edges {
 public:
  void join(std::int32_t a, std::int32_t b) {
    if (a != b && seen_.emplace(std::min(a, b), std::max(a, b)).second) pairs_.emplace_back(a, b);
  }
  [[nodiscard]] const std::vector<std::pair<std::int32_t, std::int32_t>>& pairs() const { return pairs_; }

 private:
  std::set<std::pair<std::int32_t, std::int32_t>> seen_;
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs_;
};

std::int32_t below(Random& random, std::int32_t bound) {
  return static_cast<std::int32_t>(random.below(static_cast<std::size_t>(bound)));
}

void join_chain(std::int32_t first, std::int32_t last, Edges& edges) {
  for (auto node = first + 1; node <= last; ++node) edges.join(node - 1, node);
}

void join_grid(std::int32_t first, std::int32_t nodes, Edges& edges) {
  const auto width = std::max(2, static_cast<std::int32_t>(std::sqrt(static_cast<double>(nodes))));
  for (std::int32_t k = 0; k < nodes; ++k) {
    if (k % width > 0) edges.join(first + k - 1, first + k);
    if (k >= width) edges.join(first + k - width, first + k);
  }
}

/// One to three hubs in a row, each with its leaves.
void join_hubs(Random& random, std::int32_t first, std::int32_t nodes, Edges& edges) {
  const auto hubs = std::min(nodes, 1 + below(random, 3));
  join_chain(first, first + hubs - 1, edges);
  for (auto leaf = hubs; leaf < nodes; ++leaf) edges.join(first + below(random, hubs), first + leaf);
}

void join_tree(Random& random, std::int32_t first, std::int32_t nodes, Edges& edges) {
  for (std::int32_t node = 1; node < nodes; ++node) edges.join(first + below(random, node), first + node);
}

/// One connected piece on nodes first .. first + nodes - 1; returns its shape.
std::string join_piece(Random& random, std::int32_t first, std::int32_t nodes, Edges& edges) {
  switch (random.below(6)) {
    case 0:
      join_chain(first, first + nodes - 1, edges);
      return "chain";
    case 1:
      join_chain(first, first + nodes - 1, edges);
      edges.join(first + nodes - 1, first);
      return "ring";
    case 2:
      join_grid(first, nodes, edges);
      return "grid";
    case 3:
      join_hubs(random, first, nodes, edges);
      return "hub";
    case 4:
      join_tree(random, first, nodes, edges);
      return "tree";
    default: {
      join_tree(random, first, nodes, edges);
      for (std::int32_t extra = 0; extra < 2 * nodes; ++extra) {
        const auto a = below(random, nodes), b = below(random, nodes);
        edges.join(first + a, first + b);
      }
      return "random";
    }
  }
}

}  // namespace

Wiring random_wiring(Random& random, std::int32_t nodes) {
  nodes = std::max(3, nodes);
  const bool split = nodes >= 9 && random.uniform() < 0.15;  // pieces of at least 3
  const std::int32_t pieces = split ? 2 + below(random, 2) : 1;
  Wiring wiring;
  wiring.nodes = nodes;
  Edges edges;
  std::int32_t first = 0;
  for (std::int32_t piece = 0; piece < pieces; ++piece) {
    const std::int32_t size = piece + 1 == pieces ? nodes - first : nodes / pieces;
    wiring.shape = join_piece(random, first, size, edges);
    wiring.component.insert(wiring.component.end(), static_cast<std::size_t>(size), piece);
    first += size;
  }
  if (split) wiring.shape = "disconnected";
  for (const auto& [a, b] : edges.pairs()) {
    wiring.i.push_back(a);
    wiring.j.push_back(b);
  }
  return wiring;
}

}  // namespace superstep::audit
