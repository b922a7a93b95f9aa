#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <utility>

#include "core/error.hpp"
#include "core/text/ids_in_words.hpp"
#include "core/text/quantity.hpp"
#include "network/files/network_rows.hpp"
#include "network/files/read_network.hpp"

namespace superstep {
namespace {

using Positions = std::unordered_map<std::int64_t, std::int32_t>;

Positions read_nodes(const std::string& path, Graph& graph) {
  CsvReader rows(path, node_columns());
  Positions positions;
  for (NodeRow node; next_row(rows, node);) {
    if (graph.nodes() >= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
      throw InputError(fmt::format("{}: more than 2147483647 nodes; split the network", rows.where()));
    if (!positions.emplace(node.id, static_cast<std::int32_t>(graph.nodes())).second)
      throw InputError(
          fmt::format("{}: id {} stands twice; every node needs an id of its own", rows.where(), node.id));
    graph.id.push_back(node.id);
    graph.capacity.push_back(node.capacity);
    graph.source.push_back(node.source);
    graph.initial.push_back(node.initial);
    graph.is_fixed.push_back(node.fixed ? 1 : 0);
    graph.fixed_value.push_back(node.fixed.value_or(0.0));
  }
  if (graph.nodes() == 0)
    throw InputError(fmt::format("{}: has a header but no nodes; add at least one row", path));
  return positions;
}

void read_edges(const std::string& path, const Positions& positions, NetworkInput& input) {
  CsvReader rows(path, edge_columns());
  const auto position = [&](std::int64_t node) {
    const auto found = positions.find(node);
    if (found == positions.end())
      throw InputError(
          fmt::format("{}: edge end {} is not a node; every end must be an id of the nodes file: {}",
                      rows.where(), node, ids_in_words(input.graph.id)));
    return static_cast<std::size_t>(found->second);
  };
  for (EdgeRow edge; next_row(rows, edge);)
    add_edge(input.graph, position(edge.i), position(edge.j), edge.conductance);
  if (const std::size_t joined = join_parallel_edges(input.graph); joined > 0)
    input.notes.push_back(note_of_parallel_edges(path, joined));
}

}  // namespace

std::string note_of_parallel_edges(const std::string& path, std::size_t joined) {
  return fmt::format("{}: {} parallel to others, and their conductances are summed", path,
                     quantity(joined, "edge runs", "edges run"));
}

std::size_t join_parallel_edges(Graph& graph) {
  std::vector<std::size_t> order(graph.edges());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  const auto ends = [&](std::size_t k) { return std::pair(graph.i[k], graph.j[k]); };
  const auto before = [&](std::size_t a, std::size_t b) { return ends(a) < ends(b); };
  // Only what runs parallel is touched: everybody else's edges stay in the order of their file.
  std::stable_sort(order.begin(), order.end(), before);
  std::vector<char> gone(order.size(), 0);
  std::size_t joined = 0;
  for (std::size_t k = 1, first = 0; k < order.size(); ++k) {
    if (ends(order[k]) != ends(order[first])) {
      first = k;
      continue;
    }
    graph.conductance[order[first]] += graph.conductance[order[k]];
    gone[order[k]] = 1;
    ++joined;
  }
  if (joined == 0) return 0;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < gone.size(); ++k) {
    if (gone[k]) continue;
    graph.i[kept] = graph.i[k];
    graph.j[kept] = graph.j[k];
    graph.conductance[kept++] = graph.conductance[k];
  }
  graph.i.resize(kept);
  graph.j.resize(kept);
  graph.conductance.resize(kept);
  return joined;
}

NetworkInput read_nodes_and_edges(const std::string& nodes_file, const std::string& edges_file) {
  NetworkInput input;
  const Positions positions = read_nodes(nodes_file, input.graph);
  read_edges(edges_file, positions, input);
  return input;
}

NetworkInput read_edge_list(const std::string& edges_file) {
  std::vector<std::int64_t> ids;
  {
    CsvReader rows(edges_file, edge_columns());
    for (EdgeRow edge; next_row(rows, edge);) ids.insert(ids.end(), {edge.i, edge.j});
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  if (ids.empty()) throw InputError(fmt::format("{}: has no edges; add at least one row", edges_file));
  NetworkInput input{equal_nodes(ids.size()), {}};
  Positions positions;
  for (std::size_t k = 0; k < ids.size(); ++k) positions.emplace(ids[k], static_cast<std::int32_t>(k));
  input.graph.id = std::move(ids);
  read_edges(edges_file, positions, input);
  return input;
}

Graph read_graph(const std::string& nodes_file, const std::string& edges_file) {
  return read_nodes_and_edges(nodes_file, edges_file).graph;
}

}  // namespace superstep
