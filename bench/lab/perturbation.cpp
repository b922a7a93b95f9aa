#include "bench/lab/perturbation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "core/error.hpp"
#include "integrators/registry.hpp"

namespace superstep {

PerturbationRhs::PerturbationRhs(Rhs& scene)
    : Rhs(scene.size(), scene.traits(), {scene.fields().begin(), scene.fields().end()}), scene_(scene) {
  if (!scene.traits().linear || !scene.traits().symmetric)
    throw InputError(
        "stability: the laboratory measures modes, which only a linear, symmetric scene has; ask for one "
        "field of "
        "it, with constant conductances and no radiation");
  facts_.pair_step = scene.facts().pair_step;
  facts_.fields.resize(scene.fields().size());
}

double PerturbationRhs::spectral_bound(double t, std::span<const double> y) {
  return scene_.spectral_bound(t, y);
}

double PerturbationRhs::inflow(double /*t*/, std::span<const double> y) {
  return scene_.linear_inflow(y);
}

double PerturbationRhs::linear_inflow(std::span<const double> v) const {
  return scene_.linear_inflow(v);
}

void PerturbationRhs::do_stage(double /*t*/, const Stage& stage, std::span<double> out) {
  scene_.linear_stage(stage, out);
}

void PerturbationRhs::do_linear_stage(const Stage& stage, std::span<double> out) {
  scene_.linear_stage(stage, out);
}

void PerturbationRhs::do_block_product(std::size_t field, std::span<const double> v, std::span<double> out) {
  scene_.block_product(field, v, out);
}

void PerturbationRhs::do_jacobian(double t, std::span<const double> y, std::span<double> values) {
  scene_.jacobian(t, y, values);
}

SparsePattern PerturbationRhs::build_pattern() {
  return scene_.pattern();
}

StepOperator::StepOperator(Rhs& rhs, const std::string& spec, double step)
    : step_(step), method_(make_integrator(spec)) {
  method_->prepare(rhs, unguarded_plan(rhs, {step}));
}

bool StepOperator::apply(std::span<double> e) {
  method_->start(0, e);
  if (!method_->advance(step_).ok()) return false;
  std::copy(method_->state().begin(), method_->state().end(), e.begin());
  return true;
}

double capacity_product(const Rhs& rhs, std::span<const double> a, std::span<const double> b) {
  const auto capacity = rhs.capacities();
  return rhs.reduction().sum([&](std::size_t i) { return capacity[i] * a[i] * b[i]; });
}

double normalise(const Rhs& rhs, std::span<double> e) {
  // Largest entry first: squares of a perturbation that grew to 1e200 would overflow.
  const double largest = rhs.reduction().max([&](std::size_t i) { return std::abs(e[i]); });
  if (!(largest > 0) || !std::isfinite(largest)) return largest;
  for (double& entry : e) entry /= largest;
  const double norm = std::sqrt(capacity_product(rhs, e, e));
  for (double& entry : e) entry /= norm;
  return largest * norm;
}

std::vector<double> rough_perturbation(std::size_t size) {
  std::mt19937_64 random(20260101);
  std::vector<double> e(size);
  for (double& entry : e) entry = static_cast<double>(random() >> 11) * 0x1p-52 - 1;
  return e;
}

std::vector<double> white_perturbation(const Rhs& rhs) {
  auto e = rough_perturbation(rhs.size());
  const auto capacity = rhs.capacities();
  for (std::size_t i = 0; i < e.size(); ++i) e[i] /= std::sqrt(capacity[i]);
  normalise(rhs, e);
  return e;
}

Plan unguarded_plan(const Rhs& rhs, std::vector<double> output_times) {
  constexpr double huge = 1e300;
  Plan plan;
  plan.output_times = std::move(output_times);
  plan.ranges.assign(rhs.fields().size(), {-huge, huge});
  plan.spans.assign(rhs.fields().size(), 1.0);
  return plan;
}

double growth_per_step(Rhs& rhs, const std::string& spec, double step, int steps) {
  StepOperator one_step(rhs, spec, step);
  auto e = white_perturbation(rhs);
  double growth = 0;
  for (int k = 0; k < steps; ++k) {
    if (!one_step.apply(e)) return std::numeric_limits<double>::infinity();
    growth = normalise(rhs, e);
  }
  return growth;
}

double settled_growth(Rhs& rhs, const std::string& spec, double step, int most_steps) {
  constexpr int fewest_steps = 16;  // the stiffest modes need some to win over the many
  constexpr double settled = 1e-3;  // distance to the end, when it falls like 1/k: k times the last change
  StepOperator one_step(rhs, spec, step);
  auto e = white_perturbation(rhs);
  double growth = 0;
  for (int k = 1; k <= most_steps; ++k) {
    if (!one_step.apply(e)) return std::numeric_limits<double>::infinity();
    const double before = std::exchange(growth, normalise(rhs, e));
    if (k >= fewest_steps && k * std::abs(growth - before) <= settled * growth) break;
  }
  return growth;
}

}  // namespace superstep
