#pragma once
/// Solvers of (I - c J) x = b, the linear systems of implicit methods.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "rhs/rhs.hpp"

namespace superstep {

class ShiftedSolver {
 public:
  virtual ~ShiftedSolver() = default;
  /// Makes the matrix I - c J at (t, y); keeps what it has while c and the values of the right-hand side
  /// stand. Returns false when the matrix cannot be factorized.
  [[nodiscard]] virtual bool set(double c, double t, std::span<const double> y) = 0;
  /// x for b, with a residual of at most `tolerance` of b in the capacity norm (a direct solver gives
  /// rounding). Returns false when it does not converge.
  [[nodiscard]] virtual bool solve(std::span<const double> b, std::span<double> x, double tolerance) = 0;
  [[nodiscard]] std::uint64_t factorizations() const noexcept { return factorizations_; }
  [[nodiscard]] std::uint64_t solves() const noexcept { return solves_; }
  void reset_counts() noexcept { factorizations_ = solves_ = 0; }

 protected:
  std::uint64_t factorizations_ = 0, solves_ = 0;
};

/// Sparse LU by KLU, symbolic analysis once.
[[nodiscard]] std::unique_ptr<ShiftedSolver> make_klu_solver(Rhs& rhs);
/// Conjugate gradients on C (I - c J), preconditioned by incomplete Cholesky. Needs a symmetric right-hand
/// side.
[[nodiscard]] std::unique_ptr<ShiftedSolver> make_pcg_solver(Rhs& rhs);

}  // namespace superstep
