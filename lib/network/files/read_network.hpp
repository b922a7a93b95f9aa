#pragma once
/// Networks out of files: nodes and edges, a matrix, a pore network.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "network/files/matrix_market.hpp"
#include "network/graph.hpp"

namespace superstep {

/// A graph, and what its user should know about how it was read.
struct NetworkInput {
  Graph graph;
  std::vector<std::string> notes;
};

/// Reads `id,capacity,source,initial,fixed` and `i,j,conductance`, tables of any kind. Parallel edges are
/// summed, with a note. Throws InputError with file, line, value and rule.
[[nodiscard]] NetworkInput read_nodes_and_edges(const std::string& nodes_file, const std::string& edges_file);

/// Edges alone: the nodes are the ends, in ascending order of their ids, with capacity 1. Throws InputError.
[[nodiscard]] NetworkInput read_edge_list(const std::string& edges_file);

/// What the off-diagonal entries of a matrix are.
enum class MatrixKind { automatic, laplacian, conductance };

/// A square matrix of the Matrix Market, symmetric or general (then it must be symmetric): off-diagonal
/// entries are -K_ij of a Laplacian or K_ij of a table of conductances, which has no diagonal. `automatic`
/// tells them apart by their signs. What a Laplacian's row sums to is a conductance to surroundings. Nodes
/// are called 1, 2, ..., as in the file, and have capacity 1.
///   ambient  [K or V] of the surroundings
/// Throws InputError.
[[nodiscard]] NetworkInput read_matrix_network(const std::string& file, MatrixKind kind, double ambient);

/// The same of a matrix that is in memory already: nodes and entries are counted from 0, and errors begin
/// with `name`. Entries that stand for one place are summed, in any order.
[[nodiscard]] NetworkInput network_of_matrix(const std::string& name, MatrixMarket matrix, MatrixKind kind,
                                             double ambient);

/// A pore network as OpenPNM writes it: to CSV, where throats join the pores `throat.conns[0]` and
/// `throat.conns[1]`, or to VTP, where they are the lines. Pores are called 0, 1, ....
struct PoreNetwork {
  NetworkInput input;
  std::vector<std::pair<std::string, std::vector<char>>>
      labels;  ///< names of pores' true/false columns, [pores] each
};
///   conductance  name of a column of throats
///   capacity     name of a column of pores; empty = 1
[[nodiscard]] PoreNetwork read_openpnm(const std::string& file, const std::string& conductance,
                                       const std::string& capacity);

/// What users are told of edges that were joined to others.
[[nodiscard]] std::string note_of_parallel_edges(const std::string& path, std::size_t joined);

/// Sums edges between the same nodes; returns how many were joined to another. Edges are sorted then.
std::size_t join_parallel_edges(Graph& graph);

}  // namespace superstep
