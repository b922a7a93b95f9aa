#include "integrators/detail/implicit/sundials_linear_solver.hpp"

#include <arkode/arkode_arkstep.h>
#include <fmt/format.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunlinsol/sunlinsol_spgmr.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include <algorithm>

#include "integrators/detail/implicit/incomplete_cholesky.hpp"
#include "integrators/detail/implicit/kept_jacobian.hpp"
#include "integrators/detail/implicit/klu_ordering.hpp"
#include "integrators/detail/implicit/shifted_solver.hpp"
#include "integrators/integrator.hpp"

namespace superstep {
namespace {

SundialsCallbackData& callback_of(void* data) noexcept {
  return *static_cast<SundialsCallbackData*>(data);
}

int system_of_cvode(double t, N_Vector y, N_Vector /*fy*/, SUNMatrix matrix, booleantype jacobian_ok,
                    booleantype* jacobian_new, double gamma, void* data, N_Vector, N_Vector,
                    N_Vector) noexcept {
  auto& callback = callback_of(data);
  return carried_out(callback, [&] {
    return callback.linear_solver->linear_system(t, y, matrix, jacobian_ok, jacobian_new, gamma);
  });
}

int system_of_arkode(double t, N_Vector y, N_Vector /*fy*/, SUNMatrix matrix, SUNMatrix /*mass*/,
                     booleantype jacobian_ok, booleantype* jacobian_new, double gamma, void* data, N_Vector,
                     N_Vector, N_Vector) noexcept {
  auto& callback = callback_of(data);
  return carried_out(callback, [&] {
    return callback.linear_solver->linear_system(t, y, matrix, jacobian_ok, jacobian_new, gamma);
  });
}

void set_solver(SundialsPackage package, void* integrator, SUNLinearSolver solver, SUNMatrix matrix,
                const char* what) {
  check_sundials(package == SundialsPackage::cvode ? CVodeSetLinearSolver(integrator, solver, matrix)
                                                   : ARKStepSetLinearSolver(integrator, solver, matrix),
                 what);
  if (!matrix) return;
  check_sundials(package == SundialsPackage::cvode ? CVodeSetLinSysFn(integrator, system_of_cvode)
                                                   : ARKStepSetLinSysFn(integrator, system_of_arkode),
                 "setting the linear system");
}

/// KLU on the pattern of the right-hand side: I - gamma J is filled into it in place.
class KluLinearSolver final : public SundialsLinearSolver {
 public:
  KluLinearSolver(const std::string& ordering, Rhs& rhs, N_Vector y, SUNContext context)
      : rhs_(rhs), jacobian_(rhs) {
    const auto& pattern = rhs.pattern();
    const auto n = static_cast<sunindextype>(rhs.size());
    matrix_.reset(SUNSparseMatrix(n, n, static_cast<sunindextype>(pattern.row.size()), CSC_MAT, context));
    if (!matrix_) throw std::runtime_error("SUNDIALS: out of memory for the matrix");
    std::copy(pattern.column_begin.begin(), pattern.column_begin.end(),
              SUNSparseMatrix_IndexPointers(matrix_.get()));
    std::copy(pattern.row.begin(), pattern.row.end(), SUNSparseMatrix_IndexValues(matrix_.get()));
    solver_.reset(SUNLinSol_KLU(y, matrix_.get(), context));
    if (!solver_) throw std::runtime_error("SUNDIALS: the KLU solver cannot be created");
    apply_klu_ordering(ordering, *SUNLinSol_KLUGetCommon(solver_.get()));
  }

  void attach(SundialsPackage package, void* integrator) override {
    jacobian_.forget();
    set_solver(package, integrator, solver_.get(), matrix_.get(), "attaching KLU");
  }

  int linear_system(double t, N_Vector y, SUNMatrix matrix, booleantype jacobian_ok,
                    booleantype* jacobian_new, double gamma) override {
    const bool still_valid = jacobian_.bring_to(t, sundials::entries(y), jacobian_ok != SUNFALSE);
    *jacobian_new = still_valid ? SUNFALSE : SUNTRUE;
    double* values = SUNSparseMatrix_Data(matrix);
    std::transform(jacobian_.values().begin(), jacobian_.values().end(), values,
                   [gamma](double j) { return -gamma * j; });
    for (const auto k : rhs_.pattern().diagonal) values[k] += 1;
    return 0;
  }

  [[nodiscard]] bool out_of_memory() const noexcept override {
    return SUNLinSol_KLUGetCommon(solver_.get())->status == KLU_OUT_OF_MEMORY;
  }

 private:
  Rhs& rhs_;
  KeptJacobian jacobian_;
  sundials::Matrix matrix_;
  sundials::LinearSolver solver_;
};

/// SUNDIALS' restarted GMRES, preconditioned from the right, so that what it stops at is the residual itself.
/// Where all values change alike I - gamma J is the identity, and the error of such a change is its residual;
/// an incomplete factor is up to gamma times the spectral radius larger there and hides it: insulated bodies
/// lost the mean of their heat, step by step.
class GmresLinearSolver final : public SundialsLinearSolver {
 public:
  GmresLinearSolver(Rhs& rhs, N_Vector y, SUNContext context) : preconditioner_(rhs) {
    if (!rhs.traits().linear)
      (void)rhs.pattern();  // products with J need all of it, and are no place to throw
    constexpr int krylov_vectors = 30;
    solver_.reset(SUNLinSol_SPGMR(y, SUN_PREC_RIGHT, krylov_vectors, context));
    if (!solver_) throw std::runtime_error("SUNDIALS: the GMRES solver cannot be created");
    solver_->ops->solve = solve;
    constexpr int restarts = 10;
    check_sundials(SUNLinSol_SPGMRSetMaxRestarts(solver_.get(), restarts), "setting the restarts of GMRES");
  }

  void attach(SundialsPackage package, void* integrator) override {
    const bool cvode = package == SundialsPackage::cvode;
    set_solver(package, integrator, solver_.get(), nullptr, "attaching GMRES");
    check_sundials(cvode ? CVodeSetPreconditioner(integrator, set_up, apply)
                         : ARKStepSetPreconditioner(integrator, set_up, apply),
                   "setting the preconditioner");
    check_sundials(cvode ? CVodeSetJacTimes(integrator, nullptr, jacobian_times)
                         : ARKStepSetJacTimes(integrator, nullptr, jacobian_times),
                   "setting the Jacobian product");
    // Part of Newton's tolerance that a linear solve may miss by. With the packages' 0.05 particles of
    // contrast 1e6 are up to 40 times off.
    constexpr double part = 1e-3;
    check_sundials(cvode ? CVodeSetEpsLin(integrator, part) : ARKStepSetEpsLin(integrator, part),
                   "setting the tolerance of GMRES");
  }

 private:
  /// What came nearer without getting there, which the packages take for a solution in Newton's first
  /// iteration, is none: the step is made smaller.
  static int solve(SUNLinearSolver solver, SUNMatrix matrix, N_Vector x, N_Vector b,
                   double tolerance) noexcept {
    const int flag = SUNLinSolSolve_SPGMR(solver, matrix, x, b, tolerance);
    return flag == SUNLS_RES_REDUCED ? SUNLS_CONV_FAIL : flag;
  }
  static int set_up(double t, N_Vector y, N_Vector /*fy*/, booleantype /*jacobian_ok*/,
                    booleantype* jacobian_new, double gamma, void* data) noexcept {
    auto& callback = callback_of(data);
    *jacobian_new = SUNTRUE;
    auto& self = *static_cast<GmresLinearSolver*>(callback.linear_solver);
    return carried_out(callback,
                       [&] { return self.preconditioner_.set(gamma, t, sundials::entries(y)) ? 0 : 1; });
  }
  static int apply(double /*t*/, N_Vector /*y*/, N_Vector /*fy*/, N_Vector r, N_Vector z, double /*gamma*/,
                   double /*delta*/, int /*side*/, void* data) noexcept {
    auto& callback = callback_of(data);
    static_cast<GmresLinearSolver*>(callback.linear_solver)
        ->preconditioner_.apply(sundials::entries(r), sundials::entries(z));
    return 0;
  }
  static int jacobian_times(N_Vector v, N_Vector jv, double /*t*/, N_Vector /*y*/, N_Vector /*fy*/,
                            void* data, N_Vector /*work*/) noexcept {
    auto& callback = callback_of(data);
    const auto in = sundials::entries(v), out = sundials::entries(jv);
    if (callback.rhs->traits().linear)
      callback.rhs->linear_stage({.y1 = in.data(), .a = 0, .d = 1}, out);
    else
      static_cast<GmresLinearSolver*>(callback.linear_solver)
          ->preconditioner_.jacobian()
          .multiply(0, 1, in, out);
    return 0;
  }

  IncompleteCholesky preconditioner_;
  sundials::LinearSolver solver_;
};

/// One of our own solvers behind SUNDIALS' interface: a matrix without entries remembers gamma.
class ShiftedLinearSolver final : public SundialsLinearSolver {
 public:
  ShiftedLinearSolver(std::unique_ptr<ShiftedSolver> own, SUNContext context) : own_(std::move(own)) {
    matrix_.reset(SUNMatNewEmpty(context));
    solver_.reset(SUNLinSolNewEmpty(context));
    if (!matrix_ || !solver_) throw std::runtime_error("SUNDIALS: out of memory for the linear solver");
    matrix_->ops->getid = [](SUNMatrix) { return SUNMATRIX_CUSTOM; };
    matrix_->ops->destroy = [](SUNMatrix matrix) { SUNMatFreeEmpty(matrix); };
    solver_->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_MATRIX_ITERATIVE; };
    solver_->ops->setup = [](SUNLinearSolver, SUNMatrix) { return 0; };
    solver_->ops->solve = solve;
    solver_->ops->free = [](SUNLinearSolver solver) {
      SUNLinSolFreeEmpty(solver);
      return 0;
    };
    solver_->content = this;
  }

  void attach(SundialsPackage package, void* integrator) override {
    set_solver(package, integrator, solver_.get(), matrix_.get(), "attaching the linear solver");
  }

  int linear_system(double t, N_Vector y, SUNMatrix /*matrix*/, booleantype /*jacobian_ok*/,
                    booleantype* jacobian_new, double gamma) override {
    *jacobian_new = SUNTRUE;
    return own_->set(gamma, t, sundials::entries(y)) ? 0 : 1;
  }

 private:
  static int solve(SUNLinearSolver solver, SUNMatrix /*matrix*/, N_Vector x, N_Vector b,
                   double /*tolerance*/) noexcept {
    // Newton's corrections are small already; three digits of each are enough for the test of its
    // convergence.
    constexpr double relative_residual = 1e-3;
    auto& self = *static_cast<ShiftedLinearSolver*>(solver->content);
    return self.own_->solve(sundials::entries(b), sundials::entries(x), relative_residual) ? 0 : 1;
  }

  std::unique_ptr<ShiftedSolver> own_;
  sundials::Matrix matrix_;
  sundials::LinearSolver solver_;
};

}  // namespace

int SundialsLinearSolver::linear_system(double, N_Vector, SUNMatrix, booleantype, booleantype*, double) {
  return -1;  // never called: the solver is attached without a matrix
}

void check_sundials(int flag, const char* what) {
  if (flag != 0) throw std::runtime_error(fmt::format("SUNDIALS: {} failed with flag {}", what, flag));
}

std::unique_ptr<SundialsLinearSolver> make_sundials_linear_solver(const std::string& kind,
                                                                  const std::string& ordering, Rhs& rhs,
                                                                  N_Vector y, SUNContext context) {
  if (kind == "klu") return std::make_unique<KluLinearSolver>(ordering, rhs, y, context);
  if (kind == "cholmod") return std::make_unique<ShiftedLinearSolver>(make_cholmod_solver(rhs), context);
  if (kind == "gmres") return std::make_unique<GmresLinearSolver>(rhs, y, context);
  return std::make_unique<ShiftedLinearSolver>(make_pcg_solver(rhs), context);
}

}  // namespace superstep
