#pragma once
/// A conduction graph as the user states it: nodes with ids and capacities, edges with conductances.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace superstep {

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

  [[nodiscard]] std::size_t nodes() const noexcept { return id.size(); }
  [[nodiscard]] std::size_t edges() const noexcept { return i.size(); }
};

/// Reads `id,capacity,source,initial,fixed` and `i,j,conductance`. Throws InputError with file, line, value
/// and rule.
[[nodiscard]] Graph read_graph(const std::string& nodes_file, const std::string& edges_file);

}  // namespace superstep
