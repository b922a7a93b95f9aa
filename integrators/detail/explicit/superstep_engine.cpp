#include "integrators/detail/explicit/superstep_engine.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "integrators/schemes/super_step.hpp"

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
  engine_.resize(rhs.size());
}

void SuperstepEngine::step(const SuperstepPlan& plan, double t, double h, StateVector& y) {
  if (plan.substeps.empty()) {
    engine_.step(*rhs_, plan.scheme, t, h, y, {});
    std::swap(y, engine_.result());
    return;
  }
  const double critical_step = h / superstep_length(plan.n, plan.nu);
  std::array<ChainedStage, longest_chain> links;
  for (std::size_t first = 0; first < plan.substeps.size(); first += longest_chain) {
    const auto chain = std::span(links).first(std::min(longest_chain, plan.substeps.size() - first));
    for (std::size_t k = 0; k < chain.size(); ++k) {
      const double tau = plan.substeps[first + k] * critical_step;
      chain[k] = {.t = t, .stage = {.y1 = y.data(), .a = 1, .d = tau}, .out = engine_.result().data()};
      std::swap(y, engine_.result());
      t += tau;
    }
    rhs_->chain(chain, false);
  }
}

}  // namespace superstep
