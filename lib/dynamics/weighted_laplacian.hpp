#pragma once
/// Discrete harmonic functions: every free node is the weighted mean of its neighbours.

#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/model.hpp"

namespace superstep::dynamics {

struct WeightedEdge {
  std::int32_t i, j;
  double weight;  ///< > 0
};

/// x_i = sum_j w_ij x_j / sum_j w_ij on free nodes, x given on fixed ones.
class WeightedLaplacian {
 public:
  WeightedLaplacian(CurrentSolver solver, double tolerance) : solver_(solver), tolerance_(tolerance) {}

  /// Fills x on the free nodes; on entry it holds the fixed values and, elsewhere, a first guess.
  /// Nodes without a path to a fixed node get 0: they carry nothing.
  ///   fixed [n]  what is given
  /// The tolerance is relative to the spread of the fixed values.
  /// Throws NumericalError when an iterative solver does not reach its tolerance.
  void solve(std::span<const WeightedEdge> edges, std::span<const char> fixed, std::span<double> x);

  /// Only `reached()`, for values that are solved already.
  void find_reached(std::span<const WeightedEdge> edges, std::span<const char> fixed);

  /// Nodes that a path leads to from a fixed node, fixed nodes included, in the last problem [n].
  [[nodiscard]] std::span<const char> reached() const noexcept { return reached_; }
  /// Iterations of the last solve; 0 for the direct solver and where there was nothing to solve.
  [[nodiscard]] int iterations() const noexcept { return iterations_; }

 private:
  void solve_jacobi(std::span<const WeightedEdge> edges, std::span<double> x);
  void solve_conjugate(std::span<const WeightedEdge> edges, std::span<double> x);
  void solve_direct(std::span<const WeightedEdge> edges, std::span<const char> fixed, std::span<double> x);

  CurrentSolver solver_;
  double tolerance_;
  int iterations_ = 0;
  std::vector<std::int32_t> parent_;
  std::vector<char> reached_, unknown_;  // unknown: reached and not fixed
  std::vector<double> diagonal_, residual_, direction_, product_, preconditioned_, shifted_;
};

}  // namespace superstep::dynamics
