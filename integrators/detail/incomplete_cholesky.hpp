#pragma once
/// Incomplete Cholesky preconditioner of I - c J for symmetric right-hand sides.

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <limits>
#include <span>
#include <vector>

#include "integrators/detail/kept_jacobian.hpp"

namespace superstep {

/// Factorizes S = C^(1/2) (I - c J) C^(-1/2), which is symmetric, with the fill of its own pattern.
class IncompleteCholesky {
 public:
  /// Throws Refused when the right-hand side is not symmetric in the capacity inner product.
  explicit IncompleteCholesky(Rhs& rhs);
  /// Keeps what it has while c and the values of the right-hand side stand. False when the factorization
  /// breaks down.
  [[nodiscard]] bool set(double c, double t, std::span<const double> y);
  /// z = approximate inverse of (I - c J) times r; z may be r.
  void apply(std::span<const double> r, std::span<double> z);
  [[nodiscard]] std::uint64_t factorizations() const noexcept { return factorizations_; }
  void reset_count() noexcept { factorizations_ = 0; }

 private:
  struct Entry {
    std::size_t entry, row, column;
  };
  void build_lower_triangle();

  Rhs& rhs_;
  KeptJacobian jacobian_;
  std::vector<double> root_;  ///< sqrt of the capacities
  std::vector<Entry> position_;
  Eigen::VectorXd scaled_;
  Eigen::SparseMatrix<double, Eigen::ColMajor, int> lower_;
  Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::AMDOrdering<int>> factor_;
  std::uint64_t factorizations_ = 0;
  double shift_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace superstep
