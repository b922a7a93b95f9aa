#include "integrators/detail/superstep_engine.hpp"

#include <utility>

#include "integrators/detail/super_step.hpp"

namespace superstep {

SuperstepPlan SuperstepPlan::make(int n, double nu, const std::string& order) {
  SuperstepPlan plan{n, nu, order, {}, {}};
  if (order == "recurrence") {
    first_order_chebyshev(n, 2 * nu / (1 - nu), plan.scheme);
    return plan;
  }
  plan.substeps = superstep_substeps(n, nu);
  if (order == "leja") plan.substeps = leja_ordered(std::move(plan.substeps));
  return plan;
}

void SuperstepEngine::prepare(Rhs& rhs) {
  rhs_ = &rhs;
  state_.resize(rhs.size());
  engine_.resize(rhs.size());
}

void SuperstepEngine::step(const SuperstepPlan& plan, double t, double h, double* inflow) {
  if (plan.substeps.empty()) {
    engine_.step(*rhs_, plan.scheme, t, h, state_, {}, inflow);
    std::swap(state_, engine_.result());
    return;
  }
  const double critical_step = h / superstep_length(plan.n, plan.nu);
  for (const double substep : plan.substeps) {
    const double tau = substep * critical_step;
    if (inflow) *inflow += tau * rhs_->inflow(t, state_);
    rhs_->stage(t, {.y1 = state_.data(), .a = 1, .d = tau}, engine_.result());
    std::swap(state_, engine_.result());
    t += tau;
  }
}

}  // namespace superstep
