#include "bench/lab/sweeps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/lab/catalogue.hpp"
#include "bench/lab/mode.hpp"
#include "bench/lab/networks.hpp"
#include "integrators/registry.hpp"
#include "integrators/schemes/super_step.hpp"

namespace superstep {
namespace {

constexpr int substeps = 10;
constexpr double usual_nu = 1e-3;
constexpr double nu_sweep_contrast = 1e6;
constexpr int first_steps = 5;
constexpr double part_of_limit = 0.99;

/// How far the first steps leave [0, 1], the range of initial and fixed values. A method that fails counts as
/// infinite.
double overshoot(LaboratoryNetwork& network, const std::string& spec, double step) {
  Plan plan;
  for (int k = 1; k <= first_steps; ++k) plan.output_times.push_back(k * step);
  constexpr double wide = 1e30;
  plan.ranges = {{-wide, wide}};
  const auto method = make_integrator(spec);
  method->prepare(*network.rhs, plan);
  method->start(0, network.initial);
  double worst = 0;
  for (const double t : plan.output_times) {
    if (!method->advance(t).ok()) return std::numeric_limits<double>::infinity();
    for (const double value : method->state()) worst = std::max({worst, value - 1, -value});
  }
  return worst;
}

struct MethodAtPoint {
  std::string method, spec;
  double step;  ///< s
};

/// Explicit methods at their limits, the phi rule at the superstep's length.
std::vector<MethodAtPoint> contenders(const SweepPoint& point, double lambda_max) {
  const double critical_step = part_of_limit * 2 / lambda_max;
  const double superstep = critical_step * superstep_length(point.n, point.nu);
  std::vector<MethodAtPoint> out = {
      {"forward_euler", fmt::format("forward-euler:step={:.17g}", critical_step), critical_step},
      {"sts", fmt::format("sts:n={},nu={},step={:.17g}", point.n, point.nu, critical_step), superstep}};
  for (const auto& model : stability_limits(false)) {
    if (!is_stabilised(model)) continue;
    const double step = part_of_limit * *model.beta / lambda_max;
    out.push_back({model.family, model.spec(step), step});
  }
  for (const double phi : {0.5, 0.6, 1.0})
    out.push_back({fmt::format("trapezoidal_{:g}", phi),
                   fmt::format("trapezoidal:phi={},step={:.17g}", phi, superstep), superstep});
  return out;
}

void take_worst(double& so_far, double value) {
  so_far = std::max(so_far, value);
}

/// Takes one network into the point.
void take_in(SweepPoint& point, LaboratoryNetwork& network) {
  const double truth = stiffest_mode(*network.rhs).rate;
  const SpectralBounds bounds = spectral_bounds(network.rhs->network());
  take_worst(point.edge_ratio, bounds.edge / truth);
  take_worst(point.gershgorin_ratio, bounds.gershgorin / truth);
  take_worst(point.bound_ratio, bounds.smallest() / truth);
  point.alpha = std::min(point.alpha, 2 / truth / network.rhs->facts().pair_step);
  const auto methods = contenders(point, truth);
  if (point.overshoots.empty())
    for (const auto& one : methods) point.overshoots.push_back({one.method, 0});
  for (std::size_t k = 0; k < methods.size(); ++k)
    take_worst(point.overshoots[k].spans, overshoot(network, methods[k].spec, methods[k].step));
}

SweepPoint measure(SweepPoint point, bool quick) {
  point.nodes = quick ? 100 : 300;
  point.networks = quick ? 1 : 5;
  point.n = substeps;
  point.alpha = std::numeric_limits<double>::infinity();
  for (int k = 1; k <= point.networks; ++k) {
    auto network = random_network({.nodes = point.nodes,
                                   .contrast = point.contrast,
                                   .size_ratio = point.size_ratio,
                                   .seed = static_cast<std::uint64_t>(k)});
    take_in(point, network);
  }
  return point;
}

SweepPoint point_of(const char* sweep, double contrast, double size_ratio, double nu) {
  SweepPoint point;
  point.sweep = sweep;
  point.contrast = contrast;
  point.size_ratio = size_ratio;
  point.nu = nu;
  return point;
}

}  // namespace

std::vector<SweepPoint> sweep_networks(bool quick) {
  using Values = std::vector<double>;
  const Values contrasts = quick ? Values{1, 1e6, 1e12} : Values{1, 10, 1e2, 1e3, 1e4, 1e6, 1e8, 1e10, 1e12};
  const Values ratios = quick ? Values{1, 10} : Values{1, 2, 5, 10, 20, 50, 100};
  const Values dampings =
      quick ? Values{1e-5, 0.05} : Values{1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.05, 0.1, 0.2, 0.5};
  std::vector<SweepPoint> out;
  for (const double contrast : contrasts)
    out.push_back(measure(point_of("contrast", contrast, 1, usual_nu), quick));
  for (const double ratio : ratios) out.push_back(measure(point_of("size ratio", 1, ratio, usual_nu), quick));
  for (const double nu : dampings) out.push_back(measure(point_of("nu", nu_sweep_contrast, 1, nu), quick));
  return out;
}

}  // namespace superstep
