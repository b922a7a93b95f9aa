#pragma once
/// Incomplete Cholesky preconditioner of I - c J for symmetric right-hand sides, block by block.

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "integrators/detail/implicit/kept_jacobian.hpp"

namespace superstep {

/// Factorizes S = C^(1/2) (I - c J) C^(-1/2) with the fill of its own pattern. Where S is not symmetric,
/// because conductivities follow the temperature or one field drives another, its symmetric part within each
/// field is taken: good enough for a preconditioner.
class IncompleteCholesky {
 public:
  explicit IncompleteCholesky(Rhs& rhs);
  /// Keeps what it has while c and the Jacobian stay the same. False when the factorization
  /// breaks down.
  [[nodiscard]] bool set(double c, double t, std::span<const double> y);
  /// z = approximate inverse of (I - c J) times r; z may be r.
  void apply(std::span<const double> r, std::span<double> z);
  /// The Jacobian that `set` took last.
  [[nodiscard]] const KeptJacobian& jacobian() const noexcept { return jacobian_; }
  [[nodiscard]] std::uint64_t factorizations() const noexcept { return factorizations_; }
  void reset_count() noexcept { factorizations_ = 0; }

 private:
  struct Entry {
    std::size_t entry, mirror, row, column;  ///< positions of (i,j) and (j,i) in the Jacobian
  };
  struct Block {
    std::size_t first = 0, size = 0;  ///< rows
    std::vector<Entry> position;      ///< of the entries of its lower triangle
    Eigen::SparseMatrix<double, Eigen::ColMajor, int> lower;
    Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::AMDOrdering<int>> factor;
  };
  void build_block(Block& block);

  Rhs& rhs_;
  KeptJacobian jacobian_;
  std::vector<double> root_;  ///< sqrt of the capacities
  std::vector<std::unique_ptr<Block>> blocks_;
  Eigen::VectorXd scaled_;
  std::uint64_t factorizations_ = 0;
  double shift_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace superstep
