#include "bench/lab/lab.hpp"

#include <algorithm>
#include <limits>

#include "bench/lab/critical_step.hpp"
#include "bench/lab/frozen/limits.hpp"
#include "bench/lab/methods.hpp"
#include "bench/lab/rounding.hpp"
#include "bench/lab/sweeps.hpp"
#include "bench/lab/verdicts.hpp"
#include "case/checks/health.hpp"

namespace superstep {
namespace {

/// The field that limits the step.
const FieldHealth& stiffest_field(const NetworkHealth& health) {
  return *std::max_element(health.fields.begin(), health.fields.end(),
                           [](const auto& a, const auto& b) { return a.lambda_max < b.lambda_max; });
}

std::vector<MethodStability> examine_methods(PerturbationRhs& rhs, const StiffestMode& mode, bool quick,
                                             Progress& progress) {
  std::vector<MethodStability> out;
  if (!(mode.rate > 0)) return out;
  const auto methods = stability_functions(quick);
  double whole = 0, done = 0;
  for (const auto& method : methods) whole += method.stages;
  progress.begin("stability functions", whole);
  for (const auto& method : methods) {
    out.push_back(examine_method(rhs, mode, method));
    progress.reached(done += method.stages);
  }
  progress.end();
  return out;
}

/// What only a scene has whose modes are the same at all times.
void study_modes(const Scene& scene, Progress& progress, StabilityResults& results) {
  PerturbationRhs rhs(*scene.rhs);
  const StiffestMode mode = stiffest_mode(rhs);
  results.lambda_max = mode.rate;
  results.lambda_residual = mode.residual;
  results.methods = examine_methods(rhs, mode, results.quick, progress);
  progress.begin("critical step by bisection", 1);
  results.critical_step = study_critical_step(rhs, mode, stiffest_field(assess_network(scene)));
  progress.end();
}

void take_stiffest_state(StabilityResults& results) {
  results.critical_step.limit = results.critical_step.lanczos_ratio =
      std::numeric_limits<double>::quiet_NaN();  // differs from state to state
  results.critical_step.agrees = true;
  for (const auto& state : results.states)
    if (state.lambda_max > results.lambda_max) {
      results.lambda_max = state.lambda_max;
      results.lambda_residual = state.lambda_residual;
    }
}

}  // namespace

StabilityResults run_stability_lab(const Scene& scene, bool quick, Progress& progress) {
  StabilityResults results;
  results.case_name = scene.name;
  results.title = scene.title;
  results.quick = quick;
  results.unknowns = scene.rhs->size();
  results.linear = scene.rhs->traits().linear && scene.rhs->traits().symmetric;
  study_frozen_states(scene, quick, progress, results);
  if (results.linear)
    study_modes(scene, progress, results);
  else
    take_stiffest_state(results);
  progress.begin("rounding growth", 1);
  results.rounding = study_rounding(quick);
  progress.begin("random networks", 1);
  results.sweeps = sweep_networks(quick);
  progress.end();
  results.verdicts = judge_methods(results);
  return results;
}

bool is_consistent(const StabilityResults& results) {
  const auto agrees = [](const MethodStability& one) { return one.agrees || one.order == "natural"; };
  const auto right = [](const RoundingGrowth& one) { return one.right || one.order == "natural"; };
  const auto predicted = [](const FrozenState& state) {
    return std::none_of(state.limits.begin(), state.limits.end(),
                        [](const FrozenLimit& one) { return one.verdict == FrozenLimit::Verdict::differs; });
  };
  return std::all_of(results.methods.begin(), results.methods.end(), agrees) &&
         std::all_of(results.rounding.begin(), results.rounding.end(), right) &&
         std::all_of(results.states.begin(), results.states.end(), predicted) && results.critical_step.agrees;
}

}  // namespace superstep
