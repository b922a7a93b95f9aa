#pragma once
/// The network as integrators need it: free nodes only, ordered for locality, fixed values as ghosts.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "network/graph.hpp"
#include "parallel/halo.hpp"

namespace superstep {

/// What becomes of a node of the graph.
enum class NodeRole : char {
  free,   ///< an unknown
  fixed,  ///< a known value (Dirichlet): a ghost
  idle,   ///< in a cluster in which nothing can change: keeps its initial value, costs nothing
};

/// Immutable symmetric network of n free nodes and g ghosts.
///
///   rows      row_begin[i] .. row_begin[i+1] hold the free neighbours of free node i
///   ghosts    edges from a free node to a node with a fixed value, or to the ambient that it convects to,
///             sorted by row
///   halo      where several processes share a network, each has consecutive rows of it; columns beyond its
///             own are values of rows that others have, in ascending order
struct Network {
  struct GhostEdge {
    std::int32_t row, ghost;
    double conductance;  ///< W/K or S
  };

  std::vector<std::int64_t> row_begin;  ///< [n+1]
  std::vector<std::int32_t> column;     ///< [nnz] free nodes, ascending in each row
  std::vector<double> conductance;      ///< [nnz] W/K or S; entry (i,j) equals entry (j,i)
  std::vector<GhostEdge> ghost_edges;
  double origin = 0;                       ///< K or V: all values below are differences from it
  std::vector<double> ghost_value;         ///< [g] K or V, at t = 0 where a table rules
  std::vector<std::int32_t> ghost_node;    ///< [g] position in the graph; -1 for the ambient of a convection
  std::vector<double> capacity;            ///< [n] J/K or F
  std::vector<double> source;              ///< [n] W or A
  std::vector<std::int32_t> node_of_row;   ///< [n] position in the graph
  std::vector<std::int32_t> node_of_halo;  ///< [halo] the same of rows that others have
  std::vector<std::int32_t> row_of_node;   ///< [graph nodes] row, or -1 for nodes that are not free

  std::vector<TimeTable> tables;             ///< those of values as differences from `origin`
  std::vector<std::int32_t> ghost_table;     ///< [g] index into tables, -1 = constant
  std::vector<TabledSource> tabled_sources;  ///< `node` is a row here
  std::vector<AmbientExchange> radiation;    ///< `node` is a row here, ascending
  /// A fixed value that follows a table touches fixed nodes only. It moves no row of this network, but what
  /// other fields take from it: the heat of a current, conductivities.
  bool tabled_apart = false;
  std::shared_ptr<Halo> halo;  ///< null: all rows are here

  [[nodiscard]] std::size_t size() const noexcept { return capacity.size(); }
  [[nodiscard]] std::size_t nonzeros() const noexcept { return column.size(); }
  /// Those that share the network; null = all of it is here.
  [[nodiscard]] Communicator* among() const noexcept { return halo ? &halo->among() : nullptr; }
  /// Rows here and elsewhere, and the first one that is here.
  [[nodiscard]] std::size_t all_rows() const noexcept;
  [[nodiscard]] std::size_t first_row() const noexcept;
  /// True when rows radiate, here or elsewhere.
  [[nodiscard]] bool radiates() const;
  /// False when a fixed value, a source or an ambient follows a table of time, here or elsewhere; also where
  /// such a value stands apart.
  [[nodiscard]] bool inputs_are_constant() const;
  /// Row sums of conductances [n]: all edges, and the part that leads to fixed nodes.
  [[nodiscard]] std::vector<double> total_conductance() const;
  [[nodiscard]] std::vector<double> ghost_conductance() const;
};

/// Eliminates fixed nodes, drops idle ones and edges of conductance 0, and reorders the rest. O(nodes + edges
/// log).
///   origin [K or V]  what the network's values are counted from; 0 where a field radiates
[[nodiscard]] Network build_network(const Graph& graph, std::span<const NodeRole> roles, double origin = 0);

/// Smallest pairwise step `min 2 C_i C_j / ((C_i + C_j) K_ij)` [s] over edges with a free end; infinity
/// without edges. Not a stability bound. Source: Rojek & Nisar 2026, eqs 27-29.
[[nodiscard]] double min_pair_step(const Graph& graph, std::span<const NodeRole> roles,
                                   std::span<const double> conductance);

}  // namespace superstep
