#pragma once
/// PETSc's time stepping as the method over it sees it. The library is loaded where a run asks for it, by a
/// module of its own: it brings more than a hundred others along, which nobody else should wait for.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace superstep::petsc {

/// What is integrated, in the words of the package: F = m (dy/dt - f(t, y)) = 0 with a diagonal m.
class Problem {
 public:
  virtual ~Problem() = default;
  virtual void residual(double t, const double* y, const double* slope, double* out) = 0;
  /// m (shift - J) on the rows of `Setup`. False: it is what it was the last time.
  virtual bool matrix(double t, const double* y, double shift, double* values) = 0;
};

/// Iterations stand behind incomplete factors, or behind hypre's algebraic multigrid.
enum class Solver : char { lu, cholesky, cg, gmres, multigrid_cg, multigrid_gmres };

struct Setup {
  std::vector<std::int32_t> row_begin, column;  ///< compressed rows of the matrix
  std::vector<double> allowed;                  ///< [n] local error that counts as 1 [K or V]
  double roundings = 0;                         ///< part of a value that is always allowed [-]
  bool linear = false;                          ///< one Newton iteration is exact
  std::string type, scheme;                     ///< "bdf" or "rosw"; of the latter the scheme's name
  int order = 0;                                ///< of bdf
  Solver solver = Solver::lu;
  std::vector<std::int32_t> field_end;  ///< [fields] where each ends; a multigrid is made for each alone
  double residual = 0;  ///< of a linear system, relative, where it is solved by iterations [-]
};

struct Counts {
  std::int64_t steps = 0, rejected = 0, iterations = 0;
};

/// One integration. What goes wrong is said by `message`.
class Run {
 public:
  virtual ~Run() = default;
  /// From here on: y at t, with a first step h [s]; what was before is forgotten.
  virtual bool begin(double t, std::span<const double> y, double h) = 0;
  /// One step that ends at `end` at the latest.
  virtual bool step(double end) = 0;
  [[nodiscard]] virtual double time() const noexcept = 0;
  virtual void copy_state(std::span<double> out) const = 0;
  [[nodiscard]] virtual Counts counts() const = 0;
  [[nodiscard]] virtual const std::string& message() const noexcept = 0;
};

/// Names of the module and of the functions in it; the one that makes a run throws std::runtime_error.
inline constexpr const char* module_file = "libsuperstep_petsc.so";
inline constexpr const char* make_run_name = "superstep_make_petsc_run";
using MakeRun = Run*(const Setup& setup, Problem& problem);
inline constexpr const char* initialize_name = "superstep_initialize_petsc";
using Initialize = bool();
/// Whether the package was built with another one, such as "hypre".
inline constexpr const char* was_built_with_name = "superstep_petsc_was_built_with";
using WasBuiltWith = bool(const char* package);

}  // namespace superstep::petsc
