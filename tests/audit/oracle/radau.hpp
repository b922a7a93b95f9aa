#pragma once
/// Collocation at s Radau points: order 2s - 1, damps what is stiff, solves steady rows exactly.
/// Source: Hairer & Wanner, Solving Ordinary Differential Equations II, sections IV.5 and IV.8.

#include <Eigen/Dense>

#include "audit/oracle/physics.hpp"

namespace superstep::audit {

/// Coefficients of the s-point method; found numerically.
struct RadauTable {
  explicit RadauTable(int points);
  int s;
  Eigen::VectorXd c;        ///< [s] nodes in (0, 1], the last is 1
  Eigen::MatrixXd inverse;  ///< [s*s] A^-1
  Eigen::VectorXcd lambda;  ///< [s] eigenvalues of A^-1, the real one first, then one of each pair
  Eigen::MatrixXcd vectors, vectors_inverse;  ///< A^-1 = vectors diag(lambda) vectors_inverse
  Eigen::VectorXd error;                      ///< [s] e: estimate = f(t_0)/lambda_0 + sum e_i z_i, of order s
};

struct RadauRun {
  std::vector<std::vector<std::vector<double>>> values;  ///< [fields][output times][nodes]
  std::vector<double> low, high;                         ///< [fields]
  std::size_t steps = 0;
};

///   tolerance  of the error estimate, relative to `scale` [fields]; the error itself is far smaller
///   scale      empty: each field's range so far
/// Throws std::runtime_error when a step would fall below rounding.
[[nodiscard]] RadauRun integrate_by_radau(const StatedScene& scene, double tolerance,
                                          const std::vector<double>& scale);

}  // namespace superstep::audit
