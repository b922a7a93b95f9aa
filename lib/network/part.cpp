#include "network/part.hpp"

#include <algorithm>

#include "core/index.hpp"

namespace superstep {
namespace {

/// Rows that own rows have for neighbours and others have.
std::vector<std::int64_t> rows_beyond(const Network& whole, const IndexRange& rows) {
  std::vector<std::int64_t> halo;
  const auto begin = at(whole.row_begin[at(rows.begin)]), end = at(whole.row_begin[at(rows.end)]);
  for (std::size_t k = begin; k < end; ++k)
    if (!rows.holds(whole.column[k])) halo.push_back(whole.column[k]);
  std::sort(halo.begin(), halo.end());
  halo.erase(std::unique(halo.begin(), halo.end()), halo.end());
  return halo;
}

void take_rows(const Network& whole, const IndexRange& rows, NetworkPart& part) {
  Network& out = part.network;
  const std::size_t first = at(rows.begin), owned = rows.size();
  const std::int64_t begin = whole.row_begin[first];
  for (std::size_t row = 0; row <= owned; ++row)
    out.row_begin.push_back(whole.row_begin[first + row] - begin);
  const auto entries = at(out.row_begin.back());
  out.conductance.assign(whole.conductance.begin() + begin,
                         whole.conductance.begin() + begin + static_cast<std::ptrdiff_t>(entries));
  out.column.reserve(entries);
  for (std::size_t k = at(begin); k < at(begin) + entries; ++k) {
    const std::int64_t row = whole.column[k];
    const auto place =
        rows.holds(row) ? row - rows.begin
                        : static_cast<std::int64_t>(owned) +
                              (std::lower_bound(part.halo.begin(), part.halo.end(), row) - part.halo.begin());
    out.column.push_back(static_cast<std::int32_t>(place));
  }
  const auto rows_of = [&](const auto& values) {
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(first);
    return std::vector(from, from + static_cast<std::ptrdiff_t>(owned));
  };
  out.capacity = rows_of(whole.capacity);
  out.source = rows_of(whole.source);
  out.node_of_row = rows_of(whole.node_of_row);
  for (const auto row : part.halo) out.node_of_halo.push_back(whole.node_of_row[at(row)]);
}

/// Ghosts that no own row touches are left behind.
void take_ghosts(const Network& whole, const IndexRange& rows, Network& out) {
  std::vector<std::int32_t> ghost_here(whole.ghost_value.size(), -1);
  for (auto edge : whole.ghost_edges) {
    if (!rows.holds(edge.row)) continue;
    auto& here = ghost_here[at(edge.ghost)];
    if (here < 0) {
      here = static_cast<std::int32_t>(out.ghost_value.size());
      out.ghost_value.push_back(whole.ghost_value[at(edge.ghost)]);
      out.ghost_node.push_back(whole.ghost_node[at(edge.ghost)]);
      if (!whole.ghost_table.empty()) out.ghost_table.push_back(whole.ghost_table[at(edge.ghost)]);
    }
    edge.row -= static_cast<std::int32_t>(rows.begin);
    edge.ghost = here;
    out.ghost_edges.push_back(edge);
  }
}

template <class Entry>
std::vector<Entry> of_own_rows(const std::vector<Entry>& whole, const IndexRange& rows) {
  std::vector<Entry> out;
  for (auto entry : whole) {
    if (!rows.holds(entry.node)) continue;
    entry.node -= static_cast<std::int32_t>(rows.begin);
    out.push_back(entry);
  }
  return out;
}

/// Calls one(list) for every list of plain values of a part, in a fixed order.
template <class Part, class One>
void for_lists(Part& part, const One& one) {
  auto& n = part.network;
  one(n.row_begin), one(n.column), one(n.conductance), one(n.ghost_edges), one(n.ghost_value),
      one(n.ghost_node);
  one(n.capacity), one(n.source), one(n.node_of_row), one(n.node_of_halo), one(n.ghost_table),
      one(n.tabled_sources), one(n.radiation);
  one(part.halo);
}

}  // namespace

void pack(const NetworkPart& part, Packer& out) {
  for_lists(part, [&](const auto& list) { out.put(list); });
  out.put(part.network.origin);
  out.put(part.network.tabled_apart);
  out.put(part.network.tables.size());
  for (const auto& table : part.network.tables) {
    out.put(table.time);
    out.put(table.value);
  }
}

void unpack(Unpacker& in, NetworkPart& part) {
  for_lists(part, [&](auto& list) { in.take(list); });
  in.take(part.network.origin);
  in.take(part.network.tabled_apart);
  part.network.tables.resize(in.take<std::size_t>());
  for (auto& table : part.network.tables) {
    in.take(table.time);
    in.take(table.value);
  }
}

NetworkPart rows_of(const Network& network, const IndexRange& rows) {
  NetworkPart part;
  part.halo = rows_beyond(network, rows);
  take_rows(network, rows, part);
  take_ghosts(network, rows, part.network);
  part.network.origin = network.origin;
  part.network.tabled_apart = network.tabled_apart;
  part.network.tables = network.tables;
  part.network.tabled_sources = of_own_rows(network.tabled_sources, rows);
  part.network.radiation = of_own_rows(network.radiation, rows);
  return part;
}

NetworkPart part_of(const Network& whole, const Partition& partition) {
  return rows_of(whole, {partition.begin(), partition.end()});
}

}  // namespace superstep
