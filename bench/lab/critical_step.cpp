#include "bench/lab/critical_step.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "integrators/registry.hpp"

namespace superstep {
namespace {

constexpr std::uint64_t steps_per_run = 2000;
constexpr double bracket = 1e-3;                    // relative width at which bisection ends
constexpr double agreement = 0.01;                  // of bisection and Lanczos
constexpr double published_alphas[] = {0.3, 0.15};  // Rojek & Nisar 2026, sections 9.1 and 9.2

class Runs {
 public:
  explicit Runs(PerturbationRhs& rhs) : rhs_(rhs), start_(rough_perturbation(rhs.size())) {}

  [[nodiscard]] bool stable(double step) {
    ++count_;
    const double t_end = static_cast<double>(steps_per_run) * step;
    Plan plan;
    plan.output_times = {t_end};
    plan.ranges.assign(rhs_.fields().size(), {-1, 1});
    const auto method = make_integrator(fmt::format("forward-euler:step={:.17g}", step));
    method->prepare(rhs_, plan);
    method->start(0, start_);
    return method->advance(t_end).ok();
  }
  [[nodiscard]] int count() const noexcept { return count_; }

 private:
  PerturbationRhs& rhs_;
  std::vector<double> start_;
  int count_ = 0;
};

// Between a step that is certified and the first power of two of it that fails.
double bisect_limit(Runs& runs, double certified) {
  double low = certified, high = 2 * certified;
  while (!runs.stable(low)) low *= 0.5;  // never, if the bound is one
  while (runs.stable(high)) {
    low = high;
    high *= 2;
  }
  while (high - low > bracket * low) {
    const double middle = 0.5 * (low + high);
    (runs.stable(middle) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

CriticalStepStudy study_critical_step(PerturbationRhs& rhs, const FieldHealth& health) {
  CriticalStepStudy study;
  study.steps_per_run = steps_per_run;
  if (!(health.lambda_max > 0)) {  // no conductance: nothing limits the step
    study.limit = study.lanczos_ratio = std::numeric_limits<double>::infinity();
    study.agrees = true;
    return study;
  }
  Runs runs(rhs);
  study.limit = bisect_limit(runs, health.certified_step());
  study.lanczos_ratio = health.critical_step() / study.limit;
  study.agrees = std::abs(study.lanczos_ratio - 1) <= agreement;

  const double pair = health.pair_step_bare;
  const auto add = [&](const std::string& name, double step, bool stable, const std::string& note) {
    const auto alpha = std::isfinite(pair) ? std::optional<double>(step / pair) : std::nullopt;
    study.estimates.push_back({name, step, alpha, step / study.limit, stable, note});
  };
  const auto try_out = [&](const std::string& name, double step, const std::string& note) {
    if (std::isfinite(step) && step > 0) add(name, step, runs.stable(step), note);
  };
  add("bisection on runs", study.limit, true, "the limit itself");
  try_out("Lanczos, 2/lambda_max", health.critical_step(), "sharp");
  try_out("edge bound", 2 / health.edge_bound, certified_bound);
  try_out("Gershgorin", 2 / health.gershgorin, certified_bound);
  try_out("pairwise without interface", pair, "not a bound");
  try_out("pairwise with interface", health.pair_step_full, "not a bound");
  for (const double alpha : published_alphas)
    try_out(fmt::format("{} x pairwise without interface", alpha), alpha * pair, published_rule);
  study.runs = runs.count();
  return study;
}

}  // namespace superstep
