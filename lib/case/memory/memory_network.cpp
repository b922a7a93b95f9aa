#include "case/memory/memory_network.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "case/memory/array_checks.hpp"
#include "core/error.hpp"
#include "core/text/quantity.hpp"

namespace superstep {
namespace {

constexpr std::size_t most_nodes = std::numeric_limits<std::int32_t>::max();

void require_countable(const std::string& name, std::size_t nodes) {
  if (nodes == 0) throw InputError(fmt::format("{}: the network has no nodes; at least one is needed", name));
  if (nodes > most_nodes)
    throw InputError(fmt::format("{}: the network has {} nodes; there may be {}", name, nodes, most_nodes));
}

/// Compressed rows as they are meant: each row begins where the one before it ends.
void require_rows(const NetworkArrays& arrays, const std::string& name) {
  const auto& begin = arrays.row_begin;
  require_length(name, "the matrix's data", arrays.value.size(), arrays.column.size(), "one for each index");
  if (begin.front() != 0 || begin.back() != static_cast<std::int64_t>(arrays.column.size()))
    throw InputError(
        fmt::format("{}: the matrix's indptr goes from {} to {}; it must go from 0 to the number of "
                    "entries, {}",
                    name, begin.front(), begin.back(), arrays.column.size()));
  for (std::size_t row = 0; row + 1 < begin.size(); ++row)
    if (begin[row + 1] < begin[row])
      throw InputError(fmt::format("{}: the matrix's indptr falls from {} to {} in row {}; it must not fall",
                                   name, begin[row], begin[row + 1], row));
}

NetworkInput of_matrix(const NetworkArrays& arrays, const std::string& name, MatrixKind kind,
                       double ambient) {
  require_rows(arrays, name);
  MatrixMarket matrix;
  matrix.rows = matrix.columns = arrays.row_begin.size() - 1;
  require_countable(name, matrix.rows);
  matrix.entries.reserve(arrays.value.size());
  for (std::size_t row = 0; row < matrix.rows; ++row)
    for (auto k = static_cast<std::size_t>(arrays.row_begin[row]);
         k < static_cast<std::size_t>(arrays.row_begin[row + 1]); ++k) {
      const std::int64_t column = arrays.column[k];
      if (column < 0 || column >= static_cast<std::int64_t>(matrix.columns))
        throw InputError(
            fmt::format("{}: the matrix's row {} has an entry in column {}; there are columns 0 "
                        "to {}",
                        name, row, column, matrix.columns - 1));
      if (!std::isfinite(arrays.value[k]))
        throw InputError(fmt::format("{}: entry ({}, {}) of the matrix is {}; it must be finite", name, row,
                                     column, arrays.value[k]));
      matrix.entries.push_back(
          {static_cast<std::int32_t>(row), static_cast<std::int32_t>(column), arrays.value[k], 0});
    }
  return network_of_matrix(name, std::move(matrix), kind, ambient);
}

NetworkInput of_edges(const NetworkArrays& arrays, const std::string& name) {
  require_countable(name, arrays.nodes);
  const std::size_t edges = arrays.ends.size() / 2;
  require_length(name, "edges", arrays.ends.size(), 2 * edges, "two nodes for each edge");
  require_length(name, "conductance", arrays.conductance.size(), edges, "one for each edge");
  NetworkInput input{equal_nodes(arrays.nodes), {}};
  for (std::size_t k = 0; k < edges; ++k) {
    const std::int64_t i = arrays.ends[2 * k], j = arrays.ends[2 * k + 1];
    for (const auto end : {i, j})
      if (end < 0 || end >= static_cast<std::int64_t>(arrays.nodes))
        throw InputError(fmt::format("{}: edge {} ends at node {}; there are nodes 0 to {}", name, k, end,
                                     arrays.nodes - 1));
    if (i == j) throw InputError(fmt::format("{}: edge {} joins node {} with itself; remove it", name, k, i));
    if (!(std::isfinite(arrays.conductance[k]) && arrays.conductance[k] >= 0))
      throw InputError(fmt::format("{}: conductance {} of edge {} ({}-{}) must be finite and >= 0", name,
                                   arrays.conductance[k], k, i, j));
    add_edge(input.graph, static_cast<std::size_t>(i), static_cast<std::size_t>(j), arrays.conductance[k]);
  }
  if (const std::size_t joined = join_parallel_edges(input.graph); joined > 0)
    input.notes.push_back(fmt::format("{}: {} parallel to others, and their conductances are summed", name,
                                      quantity(joined, "edge runs", "edges run")));
  return input;
}

void take(const std::string& name, const char* array, std::span<const double> values,
          std::vector<double>& out) {
  if (values.empty()) return;
  require_length(name, array, values.size(), out.size(), "one for each node");
  require_finite(name, array, values);
  out.assign(values.begin(), values.end());
}

void take_fixed(const std::string& name, std::span<const double> fixed, Graph& graph) {
  if (fixed.empty()) return;
  require_length(name, "fixed", fixed.size(), graph.nodes(), "one for each node, NaN where it is free");
  for (std::size_t k = 0; k < fixed.size(); ++k) {
    if (std::isnan(fixed[k])) continue;
    if (!std::isfinite(fixed[k]))
      throw InputError(
          fmt::format("{}: value {} of fixed is {}; it must be finite, or NaN where the node is free", name,
                      k, fixed[k]));
    graph.is_fixed[k] = 1;
    graph.fixed_value[k] = fixed[k];
  }
}

}  // namespace

NetworkInput network_of(const NetworkArrays& arrays, const std::string& name, MatrixKind kind,
                        double ambient) {
  NetworkInput input =
      arrays.row_begin.empty() ? of_edges(arrays, name) : of_matrix(arrays, name, kind, ambient);
  take(name, "capacity", arrays.capacity, input.graph.capacity);
  take(name, "source", arrays.source, input.graph.source);
  take(name, "initial", arrays.initial, input.graph.initial);
  take_fixed(name, arrays.fixed, input.graph);
  return input;
}

}  // namespace superstep
