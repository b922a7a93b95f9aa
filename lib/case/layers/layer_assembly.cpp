#include "case/layers/layer_assembly.hpp"

#include <algorithm>

#include "core/index.hpp"

namespace superstep {

LayerAssembly::LayerAssembly(const Partition& rows, std::size_t most_entries) : rows_(rows) {
  Network& network = part_.network;
  network.row_begin.reserve(rows.owned() + 1);
  network.row_begin.push_back(0);
  network.column.reserve(most_entries * rows.owned());
  network.conductance.reserve(most_entries * rows.owned());
  network.capacity.reserve(rows.owned());
  network.source.reserve(rows.owned());
}

void LayerAssembly::take(const Network& stretch, std::int64_t offset, std::int64_t first_node,
                         std::int64_t first, std::int64_t last) {
  first = std::max(first, rows_.begin()) - offset;
  last = std::min(last, rows_.end()) - offset;
  if (first >= last) return;
  Network& network = part_.network;
  for (std::int64_t row = first; row < last; ++row) {
    for (auto k = at(stretch.row_begin[at(row)]); k < at(stretch.row_begin[at(row + 1)]); ++k) {
      const std::int64_t column = stretch.column[k] + offset;
      if (!rows_.owns(column)) part_.halo.push_back(column);
      network.column.push_back(static_cast<std::int32_t>(column));
      network.conductance.push_back(stretch.conductance[k]);
    }
    network.row_begin.push_back(static_cast<std::int64_t>(network.column.size()));
    network.capacity.push_back(stretch.capacity[at(row)]);
    network.source.push_back(stretch.source[at(row)]);
  }
  take_boundary(stretch, offset, first_node, first, last);
}

void LayerAssembly::take_boundary(const Network& stretch, std::int64_t offset, std::int64_t first_node,
                                  std::int64_t first, std::int64_t last) {
  Network& network = part_.network;
  const auto own_row = [&](std::int32_t row) {
    return static_cast<std::int32_t>(row + offset - rows_.begin());
  };
  const auto taken = [&](std::int32_t row) { return row >= first && row < last; };
  for (const auto& edge : stretch.ghost_edges)
    if (taken(edge.row))
      network.ghost_edges.push_back(
          {own_row(edge.row), ghost_here(stretch, edge.ghost, first_node), edge.conductance});
  for (auto exchange : stretch.radiation)
    if (taken(exchange.node)) {
      exchange.node = own_row(exchange.node);
      network.radiation.push_back(exchange);
    }
}

std::int32_t LayerAssembly::ghost_here(const Network& stretch, std::int32_t ghost, std::int64_t first_node) {
  Network& network = part_.network;
  const std::int32_t node = stretch.ghost_node[at(ghost)];
  const double value = stretch.ghost_value[at(ghost)];
  const std::int64_t whose = node < 0 ? -1 : node + first_node;
  const auto [entry, fresh] =
      ghost_of_.try_emplace({whose, value}, static_cast<std::int32_t>(network.ghost_value.size()));
  if (fresh) {
    network.ghost_value.push_back(value);
    network.ghost_node.push_back(static_cast<std::int32_t>(whose));
    network.ghost_table.push_back(-1);
  }
  return entry->second;
}

NetworkPart LayerAssembly::finish() && {
  auto& halo = part_.halo;
  std::sort(halo.begin(), halo.end());
  halo.erase(std::unique(halo.begin(), halo.end()), halo.end());
  const std::int64_t begin = rows_.begin(), owned = static_cast<std::int64_t>(rows_.owned());
  for (auto& column : part_.network.column) {
    const std::int64_t row = column;
    const auto place = rows_.owns(row)
                           ? row - begin
                           : owned + (std::lower_bound(halo.begin(), halo.end(), row) - halo.begin());
    column = static_cast<std::int32_t>(place);
  }
  return std::move(part_);
}

}  // namespace superstep
