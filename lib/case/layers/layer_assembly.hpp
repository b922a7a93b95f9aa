#pragma once
/// Rows of a process, put together from stretches of layers.

#include <cstdint>
#include <map>
#include <utility>

#include "network/part.hpp"

namespace superstep {

class LayerAssembly {
 public:
  ///   most_entries  of a row at most: room is taken once
  LayerAssembly(const Partition& rows, std::size_t most_entries);

  /// Takes the own ones among rows [first, last) of `stretch`, whose row 0 is row `offset` of all and whose
  /// node 0 is `first_node`. Stretches come in order; neighbours of the rows that are taken must be in the
  /// same stretch.
  void take(const Network& stretch, std::int64_t offset, std::int64_t first_node, std::int64_t first,
            std::int64_t last);
  /// The part, once all rows are there.
  [[nodiscard]] NetworkPart finish() &&;

 private:
  void take_boundary(const Network& stretch, std::int64_t offset, std::int64_t first_node, std::int64_t first,
                     std::int64_t last);
  [[nodiscard]] std::int32_t ghost_here(const Network& stretch, std::int32_t ghost, std::int64_t first_node);

  Partition rows_;
  NetworkPart part_;  // columns are rows of all until it is finished
  std::map<std::pair<std::int64_t, double>, std::int32_t> ghost_of_;  // node, or -1 and the ambient's value
};

}  // namespace superstep
