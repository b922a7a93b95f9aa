#pragma once
/// Small networks with exact answers, and one way to run any integrator on them.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "integrators/integrator.hpp"
#include "rhs/network_rhs.hpp"
#include "support/sample_graphs.hpp"

namespace superstep::test {

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
