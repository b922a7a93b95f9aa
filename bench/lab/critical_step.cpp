#include "bench/lab/critical_step.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "bench/lab/frozen/growth.hpp"

namespace superstep {
namespace {

constexpr double bisection_width = 1e-5;            // relative, at which bisection ends
constexpr double agreement_with_lanczos = 0.01;     // of bisection and Lanczos
constexpr double published_alphas[] = {0.3, 0.15};  // Rojek & Nisar 2026, sections 9.1 and 9.2

}  // namespace

CriticalStepStudy study_critical_step(PerturbationRhs& rhs, const StiffestMode& mode,
                                      const FieldHealth& health) {
  CriticalStepStudy study;
  if (!(health.lambda_max > 0)) {  // no conductance: nothing limits the step
    study.limit = study.lanczos_ratio = std::numeric_limits<double>::infinity();
    study.agrees = true;
    return study;
  }
  GrowthMeter meter(rhs, mode.shape, GrowthMeter::Modes::orthogonal);
  const auto growth = [&](double step) {
    return meter.growth(fmt::format("forward-euler:step={:.17g}", step), step);
  };
  study.limit = longest_stable_step(growth, health.certified_step(), bisection_width);
  study.lanczos_ratio = health.critical_step() / study.limit;
  study.agrees = std::abs(study.lanczos_ratio - 1) <= agreement_with_lanczos;

  const double pair = health.pair_step_bare;
  const auto add = [&](const std::string& name, double step, double factor, Tendency seen,
                       const std::string& note) {
    const auto alpha = std::isfinite(pair) ? std::optional<double>(step / pair) : std::nullopt;
    study.estimates.push_back({name, step, alpha, step / study.limit, factor, seen, note});
  };
  const auto try_out = [&](const std::string& name, double step, const std::string& note) {
    if (!std::isfinite(step) || !(step > 0)) return;
    const double factor = growth(step);
    add(name, step, factor, tendency(factor), note);
  };
  add("bisection on runs", study.limit, growth(study.limit), Tendency::decays, "the limit itself");
  try_out("Lanczos, 2/lambda_max", health.critical_step(), "sharp");
  try_out("edge bound", 2 / health.edge_bound, certified_bound);
  try_out("Gershgorin", 2 / health.gershgorin, certified_bound);
  try_out("pairwise without interface", pair, "not a bound");
  try_out("pairwise with interface", health.pair_step_full, "not a bound");
  for (const double alpha : published_alphas)
    try_out(fmt::format("{} x pairwise without interface", alpha), alpha * pair, published_rule);
  study.runs = meter.runs();
  study.steps_per_run = meter.steps_per_run();
  return study;
}

}  // namespace superstep
