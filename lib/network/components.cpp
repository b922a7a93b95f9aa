#include "network/components.hpp"

#include <numeric>
#include <utility>

namespace superstep {
namespace {

// Union-find with path halving and union by size.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n), size_(n, 1) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::uint32_t root(std::uint32_t a) noexcept {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  void join(std::uint32_t a, std::uint32_t b) noexcept {
    a = root(a);
    b = root(b);
    if (a == b) return;
    if (size_[a] < size_[b]) std::swap(a, b);
    parent_[b] = a;
    size_[a] += size_[b];
  }

 private:
  std::vector<std::uint32_t> parent_, size_;
};

}  // namespace

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
