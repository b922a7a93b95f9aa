#include "integrators/detail/implicit/cvode_linear_solver.hpp"

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

/// KLU on the pattern of the right-hand side: I - gamma J is filled into it in place.
class KluLinearSolver final : public CvodeLinearSolver {
 public:
  KluLinearSolver(const std::string& ordering, Rhs& rhs, N_Vector y, SUNContext context) : jacobian_(rhs) {
    const auto& pattern = rhs.pattern();
    const auto n = static_cast<sunindextype>(rhs.size());
    matrix_.reset(SUNSparseMatrix(n, n, static_cast<sunindextype>(pattern.row.size()), CSC_MAT, context));
    if (!matrix_) throw std::runtime_error("CVODE: out of memory for the matrix");
    std::copy(pattern.column_begin.begin(), pattern.column_begin.end(),
              SUNSparseMatrix_IndexPointers(matrix_.get()));
    std::copy(pattern.row.begin(), pattern.row.end(), SUNSparseMatrix_IndexValues(matrix_.get()));
    solver_.reset(SUNLinSol_KLU(y, matrix_.get(), context));
    if (!solver_) throw std::runtime_error("CVODE: the KLU solver cannot be created");
    apply_klu_ordering(ordering, *SUNLinSol_KLUGetCommon(solver_.get()));
  }

  void attach(void* cvode) override {
    jacobian_.forget();
    check_sundials(CVodeSetLinearSolver(cvode, solver_.get(), matrix_.get()), "attaching KLU");
    check_sundials(CVodeSetLinSysFn(cvode, linear_system), "setting the linear system");
  }

 private:
  static int linear_system(double t, N_Vector y, N_Vector /*fy*/, SUNMatrix matrix, booleantype jacobian_ok,
                           booleantype* jacobian_new, double gamma, void* data, N_Vector, N_Vector,
                           N_Vector) noexcept {
    auto& callback = *static_cast<CvodeCallbackData*>(data);
    auto& self = *static_cast<KluLinearSolver*>(callback.linear_solver);
    Rhs& rhs = *callback.rhs;
    const bool still_valid = self.jacobian_.bring_to(t, sundials::entries(y), jacobian_ok != SUNFALSE);
    *jacobian_new = still_valid ? SUNFALSE : SUNTRUE;
    double* values = SUNSparseMatrix_Data(matrix);
    std::transform(self.jacobian_.values().begin(), self.jacobian_.values().end(), values,
                   [gamma](double j) { return -gamma * j; });
    for (const auto k : rhs.pattern().diagonal) values[k] += 1;
    return 0;
  }

  KeptJacobian jacobian_;
  sundials::Matrix matrix_;
  sundials::LinearSolver solver_;
};

/// SUNDIALS' restarted GMRES, preconditioned from the left.
class GmresLinearSolver final : public CvodeLinearSolver {
 public:
  GmresLinearSolver(Rhs& rhs, N_Vector y, SUNContext context) : preconditioner_(rhs) {
    constexpr int krylov_vectors = 30;
    solver_.reset(SUNLinSol_SPGMR(y, SUN_PREC_LEFT, krylov_vectors, context));
    if (!solver_) throw std::runtime_error("CVODE: the GMRES solver cannot be created");
  }

  void attach(void* cvode) override {
    check_sundials(CVodeSetLinearSolver(cvode, solver_.get(), nullptr), "attaching GMRES");
    check_sundials(CVodeSetPreconditioner(cvode, set_up, apply), "setting the preconditioner");
    check_sundials(CVodeSetJacTimes(cvode, nullptr, jacobian_times), "setting the Jacobian product");
  }

 private:
  static int set_up(double t, N_Vector y, N_Vector /*fy*/, booleantype /*jacobian_ok*/,
                    booleantype* jacobian_new, double gamma, void* data) noexcept {
    auto& callback = *static_cast<CvodeCallbackData*>(data);
    *jacobian_new = SUNTRUE;
    auto& self = *static_cast<GmresLinearSolver*>(callback.linear_solver);
    return self.preconditioner_.set(gamma, t, sundials::entries(y)) ? 0 : 1;
  }
  static int apply(double /*t*/, N_Vector /*y*/, N_Vector /*fy*/, N_Vector r, N_Vector z, double /*gamma*/,
                   double /*delta*/, int /*side*/, void* data) noexcept {
    auto& callback = *static_cast<CvodeCallbackData*>(data);
    static_cast<GmresLinearSolver*>(callback.linear_solver)
        ->preconditioner_.apply(sundials::entries(r), sundials::entries(z));
    return 0;
  }
  static int jacobian_times(N_Vector v, N_Vector jv, double /*t*/, N_Vector /*y*/, N_Vector /*fy*/,
                            void* data, N_Vector /*work*/) noexcept {
    auto& callback = *static_cast<CvodeCallbackData*>(data);
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
class ShiftedLinearSolver final : public CvodeLinearSolver {
 public:
  ShiftedLinearSolver(std::unique_ptr<ShiftedSolver> own, SUNContext context) : own_(std::move(own)) {
    matrix_.reset(SUNMatNewEmpty(context));
    solver_.reset(SUNLinSolNewEmpty(context));
    if (!matrix_ || !solver_) throw std::runtime_error("CVODE: out of memory for the linear solver");
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

  void attach(void* cvode) override {
    check_sundials(CVodeSetLinearSolver(cvode, solver_.get(), matrix_.get()), "attaching the linear solver");
    check_sundials(CVodeSetLinSysFn(cvode, linear_system), "setting the linear system");
  }

 private:
  static int linear_system(double t, N_Vector y, N_Vector /*fy*/, SUNMatrix /*matrix*/,
                           booleantype /*jacobian_ok*/, booleantype* jacobian_new, double gamma, void* data,
                           N_Vector, N_Vector, N_Vector) noexcept {
    auto& callback = *static_cast<CvodeCallbackData*>(data);
    *jacobian_new = SUNTRUE;
    auto& self = *static_cast<ShiftedLinearSolver*>(callback.linear_solver);
    return self.own_->set(gamma, t, sundials::entries(y)) ? 0 : 1;
  }
  static int solve(SUNLinearSolver solver, SUNMatrix /*matrix*/, N_Vector x, N_Vector b,
                   double /*tolerance*/) noexcept {
    // CVODE's Newton corrections are small already; three digits of each are enough for its convergence test.
    constexpr double relative_residual = 1e-3;
    auto& self = *static_cast<ShiftedLinearSolver*>(solver->content);
    return self.own_->solve(sundials::entries(b), sundials::entries(x), relative_residual) ? 0 : 1;
  }

  std::unique_ptr<ShiftedSolver> own_;
  sundials::Matrix matrix_;
  sundials::LinearSolver solver_;
};

}  // namespace

void check_sundials(int flag, const char* what) {
  if (flag != 0) throw std::runtime_error(fmt::format("CVODE: {} failed with flag {}", what, flag));
}

std::unique_ptr<CvodeLinearSolver> make_cvode_linear_solver(const std::string& kind,
                                                            const std::string& ordering, Rhs& rhs, N_Vector y,
                                                            SUNContext context) {
  if (kind == "klu") return std::make_unique<KluLinearSolver>(ordering, rhs, y, context);
  if (kind == "cholmod") return std::make_unique<ShiftedLinearSolver>(make_cholmod_solver(rhs), context);
  if (kind == "gmres") return std::make_unique<GmresLinearSolver>(rhs, y, context);
  return std::make_unique<ShiftedLinearSolver>(make_pcg_solver(rhs), context);
}

}  // namespace superstep
