#include "integrators/detail/implicit/implicit_stage.hpp"

#include <algorithm>
#include <cmath>

namespace superstep {
namespace {

constexpr int most_iterations = 10;
constexpr double slowest_convergence = 0.8;  // of one correction to the one before

}  // namespace

void ImplicitStage::prepare(Rhs& rhs, const Task& task, const std::string& solver) {
  rhs_ = &rhs;
  norm_.prepare(rhs, task.allowed);
  solver_ = make_shifted_solver(solver, rhs);
  for (auto* v : {&residual_, &change_}) v->resize(rhs.size());
}

bool ImplicitStage::set(double c, double t, std::span<const double> y) {
  c_ = c;
  return solver_->set(c, t, y);
}

ImplicitStage::Result ImplicitStage::solve(double t, std::span<const double> base, double precision,
                                           StateVector& y, StateVector& f) {
  constexpr double of_first_change = 1e-10, of_residual = 1e-13;
  const bool linear = rhs_->traits().linear;
  double before = 0;
  for (int k = 0; k < most_iterations; ++k) {
    (*rhs_)(t, y, f);
    for (std::size_t i = 0; i < y.size(); ++i) residual_[i] = base[i] + c_ * f[i] - y[i];
    const double size = norm_.of([&](std::size_t i) { return residual_[i]; });
    if (!std::isfinite(size)) return {false, "Newton's iteration left the range of numbers"};
    // What is left of the residual changes the state by less than itself: (I - c J)^-1 contracts.
    if (precision > 0 && size <= 1e-3 * precision) return {true};
    const double relative =
        precision > 0 ? std::clamp(0.1 * precision / size, of_residual, linear ? 1e-6 : 1e-3) : of_residual;
    if (!solver_->solve(residual_, change_, relative)) return {false, "the linear solver did not converge"};
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += change_[i];
    if (linear) break;
    const double change = norm_.of([&](std::size_t i) { return change_[i]; });
    if (k == 0 && precision == 0) precision = of_first_change * change;
    const double rate = before > 0 ? change / before : 0.5;
    if (rate > slowest_convergence && k > 1) return {false, "Newton's iteration did not converge"};
    before = change;
    if (k > 0 && rate < 1 && change * rate / (1 - rate) <= precision) break;
    if (k + 1 == most_iterations) return {false, "Newton's iteration did not converge"};
  }
  (*rhs_)(t, y, f);
  return {true};
}

void ImplicitStage::add_counts(Statistics& statistics) const {
  statistics.factorizations += solver_->factorizations();
  statistics.solves += solver_->solves();
}

}  // namespace superstep
