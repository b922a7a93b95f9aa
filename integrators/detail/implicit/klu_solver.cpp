#include <klu.h>

#include <algorithm>
#include <limits>
#include <new>

#include "integrators/detail/implicit/kept_jacobian.hpp"
#include "integrators/detail/implicit/klu_ordering.hpp"
#include "integrators/detail/implicit/shifted_solver.hpp"

namespace superstep {
namespace {

class KluSolver final : public ShiftedSolver {
 public:
  explicit KluSolver(Rhs& rhs) : rhs_(rhs), jacobian_(rhs) {
    const auto& pattern = rhs.pattern();
    column_begin_.assign(pattern.column_begin.begin(), pattern.column_begin.end());
    row_.assign(pattern.row.begin(), pattern.row.end());
    matrix_.resize(row_.size());
    klu_l_defaults(&common_);
    apply_klu_ordering(fastest_klu_ordering(rhs), common_);
    symbolic_ =
        klu_l_analyze(static_cast<SuiteSparse_long>(rhs.size()), column_begin_.data(), row_.data(), &common_);
    if (!symbolic_) throw std::bad_alloc();
  }
  ~KluSolver() override {
    klu_l_free_numeric(&numeric_, &common_);
    klu_l_free_symbolic(&symbolic_, &common_);
  }
  KluSolver(const KluSolver&) = delete;
  KluSolver& operator=(const KluSolver&) = delete;

  bool set(double c, double t, std::span<const double> y) override {
    const bool still_valid = jacobian_.bring_to(t, y);
    if (still_valid && c == shift_) return true;
    std::transform(jacobian_.values().begin(), jacobian_.values().end(), matrix_.begin(),
                   [c](double j) { return -c * j; });
    for (const auto k : rhs_.pattern().diagonal) matrix_[static_cast<std::size_t>(k)] += 1;
    ++factorizations_;
    shift_ = std::numeric_limits<double>::quiet_NaN();
    // I - c J is close to diagonally dominant, so the pivots of the first factorization serve all the others.
    const bool ok = numeric_ ? klu_l_refactor(column_begin_.data(), row_.data(), matrix_.data(), symbolic_,
                                              numeric_, &common_) != 0
                             : (numeric_ = klu_l_factor(column_begin_.data(), row_.data(), matrix_.data(),
                                                        symbolic_, &common_)) != nullptr;
    if (common_.status == KLU_OUT_OF_MEMORY) throw std::bad_alloc();
    if (ok) shift_ = c;
    return ok;
  }

  bool solve(std::span<const double> b, std::span<double> x, double /*tolerance*/) override {
    std::copy(b.begin(), b.end(), x.begin());
    ++solves_;
    return klu_l_solve(symbolic_, numeric_, static_cast<SuiteSparse_long>(x.size()), 1, x.data(), &common_) !=
           0;
  }

 private:
  Rhs& rhs_;
  std::vector<SuiteSparse_long> column_begin_, row_;
  KeptJacobian jacobian_;
  std::vector<double> matrix_;
  double shift_ = std::numeric_limits<double>::quiet_NaN();
  klu_l_common common_{};
  klu_l_symbolic* symbolic_ = nullptr;
  klu_l_numeric* numeric_ = nullptr;
};

}  // namespace

std::unique_ptr<ShiftedSolver> make_klu_solver(Rhs& rhs) {
  return std::make_unique<KluSolver>(rhs);
}

}  // namespace superstep
