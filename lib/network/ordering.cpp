#include "network/ordering.hpp"

#include <algorithm>

namespace superstep {
namespace {

// Breadth-first levels from `start`, appended to `order`; each node's new neighbours follow by increasing
// degree.
class LevelWalk {
 public:
  LevelWalk(std::span<const std::int64_t> row_begin, std::span<const std::int32_t> neighbour)
      : row_begin_(row_begin), neighbour_(neighbour), seen_(row_begin.size() - 1, 0) {}

  [[nodiscard]] std::int64_t degree(std::int32_t node) const noexcept {
    const auto k = static_cast<std::size_t>(node);
    return row_begin_[k + 1] - row_begin_[k];
  }
  [[nodiscard]] bool seen(std::int32_t node) const noexcept {
    return seen_[static_cast<std::size_t>(node)] == done_;
  }

  void walk(std::int32_t start, std::vector<std::int32_t>& order) {
    std::size_t next = order.size();
    visit(start, order);
    for (; next < order.size(); ++next) {
      const auto node = static_cast<std::size_t>(order[next]);
      const std::size_t first_new = order.size();
      for (auto k = row_begin_[node]; k < row_begin_[node + 1]; ++k) {
        const auto other = neighbour_[static_cast<std::size_t>(k)];
        if (!seen(other)) visit(other, order);
      }
      std::sort(
          order.begin() + static_cast<std::ptrdiff_t>(first_new), order.end(),
          [&](std::int32_t a, std::int32_t b) { return std::pair(degree(a), a) < std::pair(degree(b), b); });
    }
  }

  /// Forgets the walk of `nodes`, so that a second one can start from its far end.
  void forget(std::span<const std::int32_t> nodes) {
    for (const auto node : nodes) seen_[static_cast<std::size_t>(node)] = 0;
  }

 private:
  void visit(std::int32_t node, std::vector<std::int32_t>& order) {
    seen_[static_cast<std::size_t>(node)] = done_;
    order.push_back(node);
  }

  static constexpr char done_ = 1;
  std::span<const std::int64_t> row_begin_;
  std::span<const std::int32_t> neighbour_;
  std::vector<char> seen_;
};

}  // namespace

std::vector<std::int32_t> reverse_cuthill_mckee(std::span<const std::int64_t> row_begin,
                                                std::span<const std::int32_t> neighbour) {
  const auto n = static_cast<std::int32_t>(row_begin.size()) - 1;
  LevelWalk walk(row_begin, neighbour);
  std::vector<std::int32_t> order;
  order.reserve(static_cast<std::size_t>(n));
  for (std::int32_t node = 0; node < n; ++node) {
    if (walk.seen(node)) continue;
    // The last node of a walk lies at the rim of its component: a start there gives long, narrow levels.
    const std::size_t begin = order.size();
    walk.walk(node, order);
    const std::int32_t rim = order.back();
    walk.forget(std::span(order).subspan(begin));
    order.resize(begin);
    walk.walk(rim, order);
  }
  std::reverse(order.begin(), order.end());
  return order;
}

void group_by_length(std::span<const std::int64_t> row_begin, std::vector<std::int32_t>& order) {
  // Padding of the 17,515-particle packing: 43 % with windows of 64 rows, 14 % with 256, 4 % with 1024.
  constexpr std::size_t window = 1024;
  const auto length = [&](std::int32_t row) {
    const auto k = static_cast<std::size_t>(row);
    return row_begin[k + 1] - row_begin[k];
  };
  for (std::size_t begin = 0; begin < order.size(); begin += window)
    std::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(begin),
                     order.begin() + static_cast<std::ptrdiff_t>(std::min(begin + window, order.size())),
                     [&](std::int32_t a, std::int32_t b) { return length(a) > length(b); });
}

}  // namespace superstep
