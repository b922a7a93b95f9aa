#pragma once
/// Small networks with exact answers, and one way to run any integrator on them.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "integrators/integrator.hpp"
#include "network/graph.hpp"
#include "network/network.hpp"
#include "rhs/network_rhs.hpp"

namespace superstep::test {

/// A random connected network: a spanning tree plus extra edges; capacities in [1, 2], conductances in [1,
/// contrast].
struct RandomGraph {
  std::size_t nodes = 30;
  std::uint64_t seed = 1;
  double contrast = 10;
  std::size_t fixed = 2;  ///< nodes held at 0 and 1 in turn
  bool sources = false;
};
[[nodiscard]] Graph random_graph(const RandomGraph& settings);

/// n equal nodes in a row, conductance and capacity 1; the ends may be fixed at the given values.
[[nodiscard]] Graph chain(std::size_t nodes, std::optional<double> left = {},
                          std::optional<double> right = {});
/// One hub (node 0) with `leaves` leaves, conductance and capacity 1, hub at 1 and leaves at 0.
[[nodiscard]] Graph star(std::size_t leaves);
/// The same graph with its nodes in a random order and its ids kept with their nodes.
[[nodiscard]] Graph relabelled(const Graph& graph, std::uint64_t seed);

/// Roles without any skipping: fixed nodes fixed, all others free.
[[nodiscard]] std::vector<NodeRole> plain_roles(const Graph& graph);

/// A graph with its right-hand side and state.
struct Problem {
  explicit Problem(Graph g);
  Graph graph;
  std::unique_ptr<NetworkRhs> rhs;
  std::vector<double> initial;  ///< [free]
  [[nodiscard]] Plan plan(std::vector<double> output_times) const;
  /// Exact state at t by dense eigendecomposition of the symmetrised matrix: slow and obvious.
  [[nodiscard]] std::vector<double> exact(double t) const;
  /// Dense A = C^-1 K, row by row [free * free], straight from the graph.
  [[nodiscard]] std::vector<double> dense_matrix() const;
  /// Values by user id, free nodes only: comparable across numberings.
  [[nodiscard]] std::vector<double> by_id(const std::vector<double>& state) const;
};

struct Run {
  Outcome outcome;
  std::vector<std::vector<double>> states;  ///< one per output time reached
  Statistics statistics;
  ProbeHistory history;
  std::uint64_t sweeps = 0, jacobians = 0;
};
/// Prepares, starts and advances `spec` over the output times, tracking inflow and the first entry's history.
[[nodiscard]] Run run(const std::string& spec, Problem& problem, std::vector<double> output_times);

/// Weighted by nothing: sqrt(mean((a-b)^2)).
[[nodiscard]] double rms_difference(const std::vector<double>& a, const std::vector<double>& b);
[[nodiscard]] double max_difference(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace superstep::test
