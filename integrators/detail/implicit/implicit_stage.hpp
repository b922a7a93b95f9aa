#pragma once
/// The equation that implicit one-step methods solve, once a stage:  y - c f(t, y) = base.

#include <memory>
#include <string>

#include "integrators/detail/error_norm.hpp"
#include "integrators/detail/implicit/shifted_solver.hpp"

namespace superstep {

/// Modified Newton iteration with the Jacobian of the step's start. It begins with the residual of a
/// predictor, with f at the time of the stage: an equation that is not solved cannot be taken for one that
/// is.
class ImplicitStage {
 public:
  ///   solver  klu, cholmod or pcg
  void prepare(Rhs& rhs, const Task& task, const std::string& solver);
  /// Matrix of the next stages, at (t, y). False when it cannot be factorized.
  [[nodiscard]] bool set(double c, double t, std::span<const double> y);

  struct Result {
    bool solved = false;
    std::string reason = {};
  };
  /// Solves for y, which comes in as a predictor; `f` becomes f(t, y).
  ///   precision  of y, in units of the run's tolerance; 0 = as near to rounding as is of use, where a run
  ///   has none
  [[nodiscard]] Result solve(double t, std::span<const double> base, double precision, StateVector& y,
                             StateVector& f);
  void reset_counts() noexcept { solver_->reset_counts(); }
  void add_counts(Statistics& statistics) const;

 private:
  Rhs* rhs_ = nullptr;
  ErrorNorm norm_;
  std::unique_ptr<ShiftedSolver> solver_;
  StateVector residual_, change_;
  double c_ = 0;
};

}  // namespace superstep
