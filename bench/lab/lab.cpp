#include "bench/lab/lab.hpp"

#include <algorithm>

#include "bench/lab/critical_step.hpp"
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
  const auto methods = method_catalogue(quick);
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

}  // namespace

StabilityResults run_stability_lab(const Scene& scene, bool quick, Progress& progress) {
  PerturbationRhs rhs(*scene.rhs);
  StabilityResults results;
  results.case_name = scene.name;
  results.title = scene.title;
  results.quick = quick;
  results.unknowns = rhs.size();

  const StiffestMode mode = stiffest_mode(rhs);
  results.lambda_max = mode.rate;
  results.lambda_residual = mode.residual;
  results.methods = examine_methods(rhs, mode, quick, progress);

  progress.begin("critical step by bisection", 1);
  results.critical_step = study_critical_step(rhs, stiffest_field(assess_network(scene)));
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
  return std::all_of(results.methods.begin(), results.methods.end(), agrees) &&
         std::all_of(results.rounding.begin(), results.rounding.end(), right) && results.critical_step.agrees;
}

}  // namespace superstep
