#include "network/network.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "core/index.hpp"
#include "network/network_in_order.hpp"
#include "network/ordering.hpp"

namespace superstep {
namespace {

struct Adjacency {
  std::vector<std::int64_t> row_begin;
  std::vector<std::int32_t> neighbour;
  std::vector<double> conductance;
};

/// Both directions of every edge between two rows, counted first so that nothing reallocates.
Adjacency free_adjacency(const Graph& graph, const std::vector<std::int32_t>& row_of_node, std::size_t rows) {
  Adjacency a;
  a.row_begin.assign(rows + 1, 0);
  const auto joins_rows = [&](std::size_t k) {
    return graph.conductance[k] > 0 && row_of_node[at(graph.i[k])] >= 0 && row_of_node[at(graph.j[k])] >= 0;
  };
  for (std::size_t k = 0; k < graph.edges(); ++k) {
    if (!joins_rows(k)) continue;
    ++a.row_begin[at(row_of_node[at(graph.i[k])]) + 1];
    ++a.row_begin[at(row_of_node[at(graph.j[k])]) + 1];
  }
  std::partial_sum(a.row_begin.begin(), a.row_begin.end(), a.row_begin.begin());
  a.neighbour.resize(at(a.row_begin.back()));
  a.conductance.resize(a.neighbour.size());
  std::vector<std::int64_t> next(a.row_begin.begin(), a.row_begin.end() - 1);
  const auto put = [&](std::int32_t row, std::int32_t neighbour, double conductance) {
    const auto k = at(next[at(row)]++);
    a.neighbour[k] = neighbour;
    a.conductance[k] = conductance;
  };
  for (std::size_t k = 0; k < graph.edges(); ++k) {
    if (!joins_rows(k)) continue;
    const auto i = row_of_node[at(graph.i[k])], j = row_of_node[at(graph.j[k])];
    put(i, j, graph.conductance[k]);
    put(j, i, graph.conductance[k]);
  }
  return a;
}

/// Rows of `a` in a new order, columns renumbered and ascending.
void permute_rows(const Adjacency& a, const std::vector<std::int32_t>& order, Network& network) {
  std::vector<std::int32_t> new_row(order.size());
  for (std::size_t row = 0; row < order.size(); ++row)
    new_row[at(order[row])] = static_cast<std::int32_t>(row);
  network.row_begin.assign(1, 0);
  network.row_begin.reserve(order.size() + 1);
  network.column.reserve(a.neighbour.size());
  network.conductance.reserve(a.neighbour.size());
  std::vector<std::pair<std::int32_t, double>> entries;
  for (const auto old : order) {
    entries.clear();
    for (auto k = a.row_begin[at(old)]; k < a.row_begin[at(old) + 1]; ++k)
      entries.emplace_back(new_row[at(a.neighbour[at(k)])], a.conductance[at(k)]);
    std::sort(entries.begin(), entries.end());
    const auto begin = network.column.size();
    for (const auto& [column, conductance] : entries) {
      if (network.column.size() > begin && network.column.back() == column) {
        network.conductance.back() += conductance;  // edges that run parallel are one to the network
        continue;
      }
      network.column.push_back(column);
      network.conductance.push_back(conductance);
    }
    network.row_begin.push_back(static_cast<std::int64_t>(network.column.size()));
  }
}

void add_ghosts(const Graph& graph, std::span<const NodeRole> roles, Network& network) {
  std::vector<std::int32_t> ghost_of_node(graph.nodes(), -1);
  const auto add = [&](std::int32_t free, std::int32_t fixed, double conductance) {
    if (roles[at(free)] != NodeRole::free || roles[at(fixed)] != NodeRole::fixed || !(conductance > 0))
      return;
    auto& ghost = ghost_of_node[at(fixed)];
    if (ghost < 0) {
      ghost = static_cast<std::int32_t>(network.ghost_value.size());
      network.ghost_value.push_back(graph.fixed_at(at(fixed), 0));
      network.ghost_table.push_back(graph.fixed_table.empty() ? -1 : graph.fixed_table[at(fixed)]);
      network.ghost_node.push_back(fixed);
    }
    network.ghost_edges.push_back({network.row_of_node[at(free)], ghost, conductance});
  };
  for (std::size_t k = 0; k < graph.edges(); ++k) {
    add(graph.i[k], graph.j[k], graph.conductance[k]);
    add(graph.j[k], graph.i[k], graph.conductance[k]);
  }
}

/// Convection is conduction to a node that holds the ambient's value: one ghost for each ambient.
void add_convection(const Graph& graph, Network& network) {
  std::map<std::pair<double, std::int32_t>, std::int32_t> ghost_of_ambient;
  for (const auto& exchange : graph.convection) {
    const auto row = network.row_of_node[at(exchange.node)];
    if (row < 0) continue;
    const auto [entry, fresh] = ghost_of_ambient.try_emplace(
        {exchange.ambient, exchange.table}, static_cast<std::int32_t>(network.ghost_value.size()));
    if (fresh) {
      network.ghost_value.push_back(exchange.table < 0 ? exchange.ambient
                                                       : graph.tables[at(exchange.table)].at(0));
      network.ghost_table.push_back(exchange.table);
      network.ghost_node.push_back(-1);
    }
    network.ghost_edges.push_back({row, entry->second, exchange.coefficient});
  }
}

void add_inputs(const Graph& graph, Network& network) {
  network.tables = graph.tables;
  for (const auto& source : graph.tabled_sources)
    if (const auto row = network.row_of_node[at(source.node)]; row >= 0)
      network.tabled_sources.push_back({row, source.table});
  for (auto exchange : graph.radiation) {
    exchange.node = network.row_of_node[at(exchange.node)];
    if (exchange.node >= 0) network.radiation.push_back(exchange);
  }
  std::stable_sort(network.radiation.begin(), network.radiation.end(),
                   [](const auto& a, const auto& b) { return a.node < b.node; });
}

/// Turns the values of ghosts into differences from the origin. A table that rules a source, too, is copied.
void count_from(double origin, Network& network) {
  network.origin = origin;
  for (double& value : network.ghost_value) value -= origin;
  std::set<std::int32_t> of_sources;
  for (const auto& source : network.tabled_sources) of_sources.insert(source.table);
  std::map<std::int32_t, std::int32_t> counted;  // a table's index, and where its differences are
  for (auto& table : network.ghost_table) {
    if (table < 0) continue;
    const bool copied = of_sources.contains(table);
    const auto [entry, fresh] =
        counted.try_emplace(table, copied ? static_cast<std::int32_t>(network.tables.size()) : table);
    if (fresh && copied) network.tables.push_back(TimeTable(network.tables[at(table)]));
    table = entry->second;
    if (fresh)
      for (double& value : network.tables[at(table)].value) value -= origin;
  }
}

/// The free nodes, numbered as they stand in the graph.
struct FreeNodes {
  std::vector<std::int32_t> node, number_of_node;  // [free], [nodes] -1 elsewhere
  FreeNodes(const Graph& graph, std::span<const NodeRole> roles) : number_of_node(graph.nodes(), -1) {
    for (std::size_t k = 0; k < graph.nodes(); ++k) {
      if (roles[k] != NodeRole::free) continue;
      number_of_node[k] = static_cast<std::int32_t>(node.size());
      node.push_back(static_cast<std::int32_t>(k));
    }
  }
};

/// order[row] = number of a free node
Network assemble(const Graph& graph, std::span<const NodeRole> roles, double origin, FreeNodes free,
                 const Adjacency& adjacency, const std::vector<std::int32_t>& order) {
  Network network;
  permute_rows(adjacency, order, network);
  network.row_of_node = std::move(free.number_of_node);
  for (const auto old : order) {
    const auto node = free.node[at(old)];
    network.row_of_node[at(node)] = static_cast<std::int32_t>(network.node_of_row.size());
    network.node_of_row.push_back(node);
    network.capacity.push_back(graph.capacity[at(node)]);
    network.source.push_back(graph.source[at(node)]);
  }
  add_ghosts(graph, roles, network);
  add_convection(graph, network);
  std::stable_sort(network.ghost_edges.begin(), network.ghost_edges.end(),
                   [](const auto& a, const auto& b) { return a.row < b.row; });
  add_inputs(graph, network);
  if (origin != 0) count_from(origin, network);
  return network;
}

}  // namespace

Network build_network(const Graph& graph, std::span<const NodeRole> roles, double origin) {
  FreeNodes free(graph, roles);
  const Adjacency adjacency = free_adjacency(graph, free.number_of_node, free.node.size());
  auto order = reverse_cuthill_mckee(adjacency.row_begin, adjacency.neighbour);
  group_by_length(adjacency.row_begin, order);
  return assemble(graph, roles, origin, std::move(free), adjacency, order);
}

Network build_network_in_order(const Graph& graph, std::span<const NodeRole> roles, double origin,
                               std::span<const std::int32_t> nodes) {
  FreeNodes free(graph, roles);
  const Adjacency adjacency = free_adjacency(graph, free.number_of_node, free.node.size());
  std::vector<std::int32_t> order;
  order.reserve(free.node.size());
  for (const auto node : nodes)
    if (free.number_of_node[at(node)] >= 0) order.push_back(free.number_of_node[at(node)]);
  return assemble(graph, roles, origin, std::move(free), adjacency, order);
}

std::size_t Network::all_rows() const noexcept {
  return halo ? static_cast<std::size_t>(halo->partition().rows()) : size();
}

std::size_t Network::first_row() const noexcept {
  return halo ? static_cast<std::size_t>(halo->partition().begin()) : 0;
}

bool Network::radiates() const {
  return halo ? halo->among().any(!radiation.empty()) : !radiation.empty();
}

bool Network::inputs_are_constant() const {
  const auto is_constant = [](std::int32_t table) { return table < 0; };
  const bool here = !tabled_apart && tabled_sources.empty() &&
                    std::all_of(ghost_table.begin(), ghost_table.end(), is_constant) &&
                    std::all_of(radiation.begin(), radiation.end(),
                                [&](const auto& exchange) { return is_constant(exchange.table); });
  return halo ? !halo->among().any(!here) : here;
}

std::vector<double> Network::ghost_conductance() const {
  std::vector<double> sums(size(), 0.0);
  for (const auto& edge : ghost_edges) sums[at(edge.row)] += edge.conductance;
  return sums;
}

std::vector<double> Network::total_conductance() const {
  std::vector<double> sums = ghost_conductance();
  for (std::size_t row = 0; row < size(); ++row)
    for (auto k = row_begin[row]; k < row_begin[row + 1]; ++k) sums[row] += conductance[at(k)];
  return sums;
}

double min_pair_step(const Graph& graph, std::span<const NodeRole> roles,
                     std::span<const double> conductance) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < graph.edges(); ++k) {
    const auto i = at(graph.i[k]), j = at(graph.j[k]);
    if (!(conductance[k] > 0) || (roles[i] != NodeRole::free && roles[j] != NodeRole::free)) continue;
    // A fixed node without a capacity is as slow as can be.
    const auto inverse = [&](std::size_t node) {
      return graph.capacity[node] > 0 ? 1 / graph.capacity[node] : 0.0;
    };
    const double equivalent = 2 / (inverse(i) + inverse(j));
    smallest = std::min(smallest, equivalent / conductance[k]);
  }
  return smallest;
}

}  // namespace superstep
