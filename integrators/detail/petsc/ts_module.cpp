/// The only file with PETSc's time stepping (TS): with its neighbours a module of its own, loaded where a run
/// asks for it.
/// Source: Abhyankar et al. (2018), PETSc/TS: A Modern Scalable ODE/DAE Solver Library, arXiv:1806.01437.

#include <petscts.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "integrators/detail/petsc/multigrid.hpp"
#include "integrators/detail/petsc/package.hpp"
#include "integrators/detail/petsc/ts_run.hpp"

namespace superstep::petsc {
namespace {

class TimeStepping final : public Run {
 public:
  TimeStepping(const Setup& setup, Problem& problem)
      : setup_(setup), problem_(&problem), values_(setup.column.size()) {
    create_objects();
    choose_scheme();
    choose_solver();
  }

  bool begin(double t, std::span<const double> y, double h) override {
    PetscScalar* entries = nullptr;
    uncut_ = 0;
    return done(VecGetArrayWrite(state_, &entries), "state") &&
           (std::copy(y.begin(), y.end(), entries), done(VecRestoreArrayWrite(state_, &entries), "state")) &&
           done(TSSetTime(ts_, t), "time") && done(TSSetTimeStep(ts_, h), "step") &&
           done(TSRestartStep(ts_), "restart");
  }

  bool step(double end) override {
    constexpr double roundings = 16 * std::numeric_limits<double>::epsilon();
    const double begin = time(), close = roundings * std::max(std::abs(begin), std::abs(end));
    if (end - begin <= close) return done(TSSetTime(ts_, end), "time");  // breakpoints and outputs may be so
    PetscReal h = 0;
    TSGetTimeStep(ts_, &h);
    h = std::max(h, std::exchange(uncut_, 0));
    const bool cut = h > end - begin;
    if (!done(TSSetMaxTime(ts_, end), "end") || !done(TSSetTimeStep(ts_, std::min(h, end - begin)), "step") ||
        !done(TSStep(ts_), "a step"))
      return false;
    TSConvergedReason reason = TS_CONVERGED_ITERATING;
    TSGetConvergedReason(ts_, &reason);
    if (reason < 0) {
      message_ = TSConvergedReasons[reason];
      return false;
    }
    const double t = time();
    if (t < end - close) return true;
    if (cut) uncut_ = h;
    // Differences over a step so short are roundings, which the next one, as long as before, would blow up.
    constexpr double sliver = 1e-4;
    if (end - begin < sliver * h && !done(TSRestartStep(ts_), "restart")) return false;
    return t == end || done(TSSetTime(ts_, end), "time");
  }

  [[nodiscard]] double time() const noexcept override {
    PetscReal t = 0;
    TSGetTime(ts_, &t);
    return t;
  }
  void copy_state(std::span<double> out) const override {
    const PetscScalar* entries = nullptr;
    check(VecGetArrayRead(state_, &entries), "state");
    std::copy(entries, entries + out.size(), out.begin());
    check(VecRestoreArrayRead(state_, &entries), "state");
  }
  [[nodiscard]] Counts counts() const override {
    PetscInt steps = 0, rejected = 0, iterations = 0;
    TSGetStepNumber(ts_, &steps);
    TSGetStepRejections(ts_, &rejected);
    TSGetSNESIterations(ts_, &iterations);
    return {steps, rejected, iterations};
  }
  [[nodiscard]] const std::string& message() const noexcept override { return message_; }

 private:
  bool done(PetscErrorCode code, const char* what) {
    if (code == 0) return true;
    message_ = std::string(what) + ": " + last_message();
    return false;
  }

  [[nodiscard]] bool has_multigrid() const noexcept {
    return setup_.solver == Solver::multigrid_cg || setup_.solver == Solver::multigrid_gmres;
  }
  [[nodiscard]] bool is_for_symmetric() const noexcept {
    return setup_.solver == Solver::cholesky || setup_.solver == Solver::cg ||
           setup_.solver == Solver::multigrid_cg;
  }
  [[nodiscard]] bool iterates() const noexcept {
    return setup_.solver != Solver::lu && setup_.solver != Solver::cholesky;
  }

  void create_objects() {
    const auto n = static_cast<PetscInt>(setup_.allowed.size());
    check(VecCreateSeq(PETSC_COMM_SELF, n, state_.fill()), "VecCreateSeq");
    check(VecDuplicate(state_, allowed_.fill()), "VecDuplicate");
    PetscScalar* entries = nullptr;
    check(VecGetArrayWrite(allowed_, &entries), "tolerances");
    std::copy(setup_.allowed.begin(), setup_.allowed.end(), entries);
    check(VecRestoreArrayWrite(allowed_, &entries), "tolerances");
    // The arrays are the run's own: what the matrix is filled with is written in place.
    check(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, n, n, setup_.row_begin.data(), setup_.column.data(),
                                    values_.data(), matrix_.fill()),
          "MatCreateSeqAIJWithArrays");
    if (is_for_symmetric())
      for (const MatOption option : {MAT_SPD, MAT_SPD_ETERNAL, MAT_SYMMETRIC, MAT_SYMMETRY_ETERNAL})
        check(MatSetOption(matrix_, option, PETSC_TRUE), "MatSetOption");
    check(TSCreate(PETSC_COMM_SELF, ts_.fill()), "TSCreate");
    check(TSSetSolution(ts_, state_), "TSSetSolution");
    check(TSSetProblemType(ts_, setup_.linear ? TS_LINEAR : TS_NONLINEAR), "TSSetProblemType");
    check(TSSetEquationType(ts_, TS_EQ_IMPLICIT), "TSSetEquationType");
    check(TSSetIFunction(ts_, nullptr, residual, this), "TSSetIFunction");
    check(TSSetIJacobian(ts_, matrix_, matrix_, jacobian, this), "TSSetIJacobian");
  }

  void choose_scheme() {
    check(TSSetType(ts_, setup_.type.c_str()), "TSSetType");
    if (setup_.type == "bdf")
      check(TSBDFSetOrder(ts_, setup_.order), "TSBDFSetOrder");
    else
      check(TSRosWSetType(ts_, setup_.scheme.c_str()), "TSRosWSetType");
    check(TSSetExactFinalTime(ts_, TS_EXACTFINALTIME_MATCHSTEP), "TSSetExactFinalTime");
    check(TSSetMaxSteps(ts_, PETSC_MAX_INT), "TSSetMaxSteps");
    check(TSSetErrorIfStepFails(ts_, PETSC_FALSE), "TSSetErrorIfStepFails");
    constexpr PetscInt most_trials = 60;  // of one step
    check(TSSetMaxStepRejections(ts_, most_trials), "TSSetMaxStepRejections");
    check(TSSetMaxSNESFailures(ts_, -1), "TSSetMaxSNESFailures");  // a smaller step then
    check(TSSetTolerances(ts_, PETSC_DECIDE, allowed_, setup_.roundings, nullptr), "TSSetTolerances");
    TSAdapt adapt = nullptr;
    check(TSGetAdapt(ts_, &adapt), "TSGetAdapt");
    check(TSAdaptSetType(adapt, TSADAPTBASIC), "TSAdaptSetType");
    check(TSAdaptSetStepLimits(adapt, std::numeric_limits<double>::min(), std::numeric_limits<double>::max()),
          "TSAdaptSetStepLimits");
  }

  void choose_solver() {
    SNES snes = nullptr;
    check(TSGetSNES(ts_, &snes), "TSGetSNES");
    check(SNESSetType(snes, setup_.linear || setup_.type == "rosw" ? SNESKSPONLY : SNESNEWTONLS),
          "SNESSetType");
    // A step begins with a prediction: a few digits of the correction are all that its error can see.
    constexpr double of_residual = 1e-4, of_step = 1e-4;
    constexpr PetscInt most_iterations = 10;
    check(SNESSetTolerances(snes, PETSC_DEFAULT, of_residual, of_step, most_iterations, PETSC_DEFAULT),
          "SNESSetTolerances");
    KSP ksp = nullptr;
    PC pc = nullptr;
    check(SNESGetKSP(snes, &ksp), "SNESGetKSP");
    check(KSPGetPC(ksp, &pc), "KSPGetPC");
    if (iterates()) {
      const bool cg = is_for_symmetric();
      check(KSPSetType(ksp, cg ? KSPCG : KSPGMRES), "KSPSetType");
      check(KSPSetTolerances(ksp, setup_.residual, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT),
            "KSPSetTolerances");
      if (has_multigrid())
        choose_multigrid(pc, setup_.field_end);
      else
        choose_incomplete_factor(pc, cg);
      // What it stops at is the residual itself: an incomplete factor hides changes that all values share.
      if (!cg) check(KSPSetPCSide(ksp, PC_RIGHT), "KSPSetPCSide");
      return;
    }
    choose_factors(ksp, pc);
  }

  /// A pivot that is none makes the step smaller: I - gamma J becomes the identity. Shifted diagonals, the
  /// package's way, are tried without end where capacities differ by more than roundings.
  static void choose_incomplete_factor(PC pc, bool symmetric) {
    check(PCSetType(pc, symmetric ? PCICC : PCILU), "PCSetType");
    check(PCFactorSetShiftType(pc, MAT_SHIFT_NONE), "PCFactorSetShiftType");
  }

  void choose_factors(KSP ksp, PC pc) {
    const bool cholesky = setup_.solver == Solver::cholesky;
    check(KSPSetType(ksp, KSPPREONLY), "KSPSetType");
    check(PCSetType(pc, cholesky ? PCCHOLESKY : PCLU), "PCSetType");
    const char* package = cholesky ? MATSOLVERCHOLMOD : MATSOLVERKLU;
    PetscBool there = PETSC_FALSE;
    check(MatGetFactorAvailable(matrix_, package, cholesky ? MAT_FACTOR_CHOLESKY : MAT_FACTOR_LU, &there),
          "MatGetFactorAvailable");
    if (there) check(PCFactorSetMatSolverType(pc, package), "PCFactorSetMatSolverType");
  }

  static PetscErrorCode residual(TS, PetscReal t, Vec y, Vec slope, Vec out, void* self) {
    const PetscScalar *at = nullptr, *rate = nullptr;
    PetscScalar* f = nullptr;
    PetscFunctionBeginUser;
    PetscCall(VecGetArrayRead(y, &at));
    PetscCall(VecGetArrayRead(slope, &rate));
    PetscCall(VecGetArrayWrite(out, &f));
    static_cast<TimeStepping*>(self)->problem_->residual(t, at, rate, f);
    PetscCall(VecRestoreArrayWrite(out, &f));
    PetscCall(VecRestoreArrayRead(slope, &rate));
    PetscCall(VecRestoreArrayRead(y, &at));
    PetscFunctionReturn(0);
  }

  static PetscErrorCode jacobian(TS, PetscReal t, Vec y, Vec, PetscReal shift, Mat, Mat matrix, void* self) {
    auto& run = *static_cast<TimeStepping*>(self);
    const PetscScalar* at = nullptr;
    PetscFunctionBeginUser;
    PetscCall(VecGetArrayRead(y, &at));
    const bool changed = run.problem_->matrix(t, at, shift, run.values_.data());
    PetscCall(VecRestoreArrayRead(y, &at));
    if (!changed) PetscFunctionReturn(0);  // and so do its factors stay
    PetscScalar* own = nullptr;
    PetscCall(MatSeqAIJGetArray(matrix, &own));
    PetscCall(MatSeqAIJRestoreArray(matrix, &own));  // says that the values are others now
    PetscFunctionReturn(0);
  }

  Setup setup_;
  Problem* problem_;
  std::vector<double> values_;
  Owned<Vec, VecDestroy> state_, allowed_;
  Owned<Mat, MatDestroy> matrix_;
  Owned<TS, TSDestroy> ts_;
  double uncut_ =
      0;  ///< what the last step would have been, were it not for an instant to end at [s]; 0 = it was all
  std::string message_;
};

}  // namespace
}  // namespace superstep::petsc

extern "C" bool superstep_initialize_petsc() {
  try {
    superstep::petsc::initialize();
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

extern "C" bool superstep_petsc_was_built_with(const char* package) {
  PetscBool there = PETSC_FALSE;
  return PetscHasExternalPackage(package, &there) == 0 && there;
}

extern "C" superstep::petsc::Run* superstep_make_petsc_run(const superstep::petsc::Setup& setup,
                                                           superstep::petsc::Problem& problem) {
  return new superstep::petsc::TimeStepping(setup, problem);
}
