#pragma once
/// A conduction graph as the user states it: nodes with ids and capacities, edges with conductances.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/time_table.hpp"

namespace superstep {

/// Exchange of one node with its surroundings.
struct AmbientExchange {
  std::int32_t node = 0;
  double coefficient = 0;   ///< convection: h A [W/K]; radiation: emissivity sigma_SB A [W/K^4]
  double ambient = 0;       ///< K, where `table` is -1
  std::int32_t table = -1;  ///< index into the graph's tables
};

/// A source that changes in time.
struct TabledSource {
  std::int32_t node = 0, table = 0;
};

/// n nodes and m edges of one field; positions 0..n-1 are the user's order.
struct Graph {
  std::vector<std::int64_t> id;     ///< [n] the user's ids, unique
  std::vector<double> capacity;     ///< [n] J/K or F, > 0
  std::vector<double> source;       ///< [n] W or A, constant
  std::vector<double> initial;      ///< [n] K or V
  std::vector<double> fixed_value;  ///< [n] K or V, meaningful where is_fixed
  std::vector<char> is_fixed;       ///< [n]
  std::vector<std::int32_t> i, j;   ///< [m] positions
  std::vector<double> conductance;  ///< [m] W/K or S, >= 0

  std::vector<TimeTable> tables;          ///< whatever changes in time
  std::vector<std::int32_t> fixed_table;  ///< [n], or empty: table of a fixed value, -1 = constant
  std::vector<TabledSource> tabled_sources;
  std::vector<AmbientExchange> convection, radiation;

  [[nodiscard]] std::size_t nodes() const noexcept { return id.size(); }
  [[nodiscard]] std::size_t edges() const noexcept { return i.size(); }
  /// Fixed value of a node at time t [K or V]; meaningful where is_fixed.
  [[nodiscard]] double fixed_at(std::size_t node, double t) const noexcept {
    const auto table = fixed_table.empty() ? -1 : fixed_table[node];
    return table < 0 ? fixed_value[node] : tables[static_cast<std::size_t>(table)].at(t);
  }
};

/// n nodes with ids 0, 1, ..., capacity 1, values 0, none of them fixed, and no edges.
[[nodiscard]] Graph equal_nodes(std::size_t n);
/// One edge more, from the lower position to the higher.
void add_edge(Graph& graph, std::size_t i, std::size_t j, double conductance);

/// Reads `id,capacity,source,initial,fixed` and `i,j,conductance`. Throws InputError with file, line, value
/// and rule.
[[nodiscard]] Graph read_graph(const std::string& nodes_file, const std::string& edges_file);

}  // namespace superstep
