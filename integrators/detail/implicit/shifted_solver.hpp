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
  /// Makes the matrix I - c J at (t, y); keeps what it has while c and the Jacobian
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

/// The fastest of `klu`, `cholmod` and `pcg` for a right-hand side, by measurements on packings and lattices:
///
///   unknowns            125    384    1440   3584   9680   16 538   93 104   (CVODE, rtol = 1e-6; CPU s)
///   klu, best ordering  .0007  .0050  .057   .41    3.9    2.0      > 100
///   cholmod             .0007  .0052  .11    .34    1.5    1.9      39
///   pcg                 .0009  .0041  .020   .057   0.20   0.72     4.9
///
/// (16 538: the cylinder of the source paper, longer than wide; the others are cubes.)
[[nodiscard]] std::string fastest_linear_solver(const Rhs& rhs);
/// Of `amd` and `metis` for KLU.
[[nodiscard]] std::string fastest_klu_ordering(const Rhs& rhs);

/// `klu`, `cholmod` or `pcg`. Throws Refused where the right-hand side does not suit it.
[[nodiscard]] std::unique_ptr<ShiftedSolver> make_shifted_solver(const std::string& name, Rhs& rhs);
/// Sparse LU by KLU, symbolic analysis once.
[[nodiscard]] std::unique_ptr<ShiftedSolver> make_klu_solver(Rhs& rhs);
/// Sparse Cholesky by CHOLMOD on C (I - c J), symbolic analysis once. Needs a symmetric right-hand side.
[[nodiscard]] std::unique_ptr<ShiftedSolver> make_cholmod_solver(Rhs& rhs);
/// Conjugate gradients on C (I - c J), preconditioned by incomplete Cholesky. Needs a symmetric right-hand
/// side.
[[nodiscard]] std::unique_ptr<ShiftedSolver> make_pcg_solver(Rhs& rhs);

}  // namespace superstep
