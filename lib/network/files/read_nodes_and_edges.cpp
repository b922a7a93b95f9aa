#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <utility>

#include "core/error.hpp"
#include "core/text/csv.hpp"
#include "network/graph.hpp"

namespace superstep {
namespace {

using Positions = std::unordered_map<std::int64_t, std::int32_t>;

Positions read_nodes(const std::string& path, Graph& graph) {
  enum : std::size_t { id, capacity, source, initial, fixed };
  CsvReader rows(path, {"id", "capacity", "source", "initial", "fixed"});
  Positions positions;
  while (rows.next()) {
    const auto node = rows.integer(id);
    if (graph.nodes() >= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
      throw InputError(fmt::format("{}: more than 2147483647 nodes; split the network", rows.where()));
    if (!positions.emplace(node, static_cast<std::int32_t>(graph.nodes())).second)
      throw InputError(
          fmt::format("{}: id {} stands twice; every node needs an id of its own", rows.where(), node));
    if (!(rows.number(capacity) > 0))
      throw InputError(fmt::format("{}: capacity of node {} is {}; it must be > 0 (J/K or F)", rows.where(),
                                   node, rows.number(capacity)));
    const bool is_fixed = !rows.text(fixed).empty();
    graph.id.push_back(node);
    graph.capacity.push_back(rows.number(capacity));
    graph.source.push_back(rows.number(source));
    graph.initial.push_back(rows.number(initial));
    graph.is_fixed.push_back(is_fixed ? 1 : 0);
    graph.fixed_value.push_back(is_fixed ? rows.number(fixed) : 0.0);
  }
  if (graph.nodes() == 0)
    throw InputError(fmt::format("{}: has a header but no nodes; add at least one row", path));
  return positions;
}

struct EdgeLine {
  std::int32_t i, j;
  std::size_t line;
};

void reject_duplicates(const std::string& path, const Graph& graph, std::vector<EdgeLine> edges) {
  std::sort(edges.begin(), edges.end(), [](const EdgeLine& a, const EdgeLine& b) {
    return std::tie(a.i, a.j, a.line) < std::tie(b.i, b.j, b.line);
  });
  const auto twice = std::adjacent_find(edges.begin(), edges.end(), [](const EdgeLine& a, const EdgeLine& b) {
    return a.i == b.i && a.j == b.j;
  });
  if (twice == edges.end()) return;
  throw InputError(
      fmt::format("{}:{}: edge {}-{} stands already in line {}; join the two into one conductance", path,
                  (twice + 1)->line, graph.id[static_cast<std::size_t>(twice->i)],
                  graph.id[static_cast<std::size_t>(twice->j)], twice->line));
}

void read_edges(const std::string& path, const Positions& positions, Graph& graph) {
  enum : std::size_t { i, j, conductance };
  CsvReader rows(path, {"i", "j", "conductance"});
  std::vector<EdgeLine> lines;
  const auto position = [&](std::size_t column) {
    const auto node = rows.integer(column);
    const auto found = positions.find(node);
    if (found == positions.end())
      throw InputError(fmt::format("{}: edge end {} is not a node; every end must be an id of the nodes file",
                                   rows.where(), node));
    return found->second;
  };
  while (rows.next()) {
    const auto a = position(i), b = position(j);
    const double value = rows.number(conductance);
    if (a == b)
      throw InputError(fmt::format("{}: edge {}-{} joins a node with itself; remove it", rows.where(),
                                   rows.integer(i), rows.integer(j)));
    if (!(value >= 0))
      throw InputError(fmt::format("{}: conductance {}-{} is {}; it must be finite and >= 0 (W/K or S)",
                                   rows.where(), rows.integer(i), rows.integer(j), value));
    graph.i.push_back(std::min(a, b));
    graph.j.push_back(std::max(a, b));
    graph.conductance.push_back(value);
    lines.push_back({std::min(a, b), std::max(a, b), rows.line()});
  }
  reject_duplicates(path, graph, std::move(lines));
}

}  // namespace

Graph read_graph(const std::string& nodes_file, const std::string& edges_file) {
  Graph graph;
  const Positions positions = read_nodes(nodes_file, graph);
  read_edges(edges_file, positions, graph);
  return graph;
}

}  // namespace superstep
