#include "bench/lab/rounding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bench/lab/catalogue.hpp"
#include "bench/lab/chain.hpp"
#include "bench/lab/perturbation.hpp"
#include "integrators/registry.hpp"
#include "integrators/schemes/super_step.hpp"
#include "integrators/schemes/three_term.hpp"

namespace superstep {
namespace {

constexpr double lost = std::numeric_limits<double>::infinity();
constexpr std::size_t chain_nodes = 300;
constexpr double run_time = 20000;     // s, twice the chain's slowest relaxation time
constexpr double right_below = 1e-6;   // spans of rounding at the end of a run
constexpr int spectrum_points = 1000;  // of [0, 2] in units of 1/critical step

double largest_partial_product(const std::vector<double>& substeps, double x) {
  double largest = 1, leading = 1, trailing = 1;
  for (std::size_t k = 0; k < substeps.size(); ++k) {
    leading *= 1 - substeps[k] * x;
    trailing *= 1 - substeps[substeps.size() - 1 - k] * x;
    largest = std::max({largest, std::abs(leading), std::abs(trailing)});
  }
  return largest;
}

// What the end owes to one unit at stage j, for the largest j: the recurrence run backwards.
double largest_stage_response(const ThreeTermScheme& scheme, double z) {
  double later = 0, now = 1, largest = 1;
  for (auto j = static_cast<std::size_t>(scheme.stages); j >= 2; --j) {
    const double below = j < static_cast<std::size_t>(scheme.stages) ? scheme.n[j + 1] : 0;
    const double earlier = (scheme.m[j] - scheme.mt[j] * z) * now + below * later;
    later = std::exchange(now, earlier);
    largest = std::max(largest, std::abs(now));
  }
  return largest;
}

struct ChainRun {
  double error_of_rounding = 0;  ///< against the same supersteps done exactly
  double error_at_end = 0;       ///< against the exact solution
};

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double difference = std::abs(a[k] - b[k]);
    if (!(difference <= largest)) largest = difference;
  }
  return largest;
}

ChainRun run_chain(Chain& chain, SuperstepShape shape, const std::string& order, int supersteps) {
  const int n = shape.n;
  const double nu = shape.nu;
  constexpr double part_of_limit = 0.99;
  const double critical_step = part_of_limit * 2 / chain.largest_rate();
  const double t_end = supersteps * critical_step * superstep_length(n, nu);
  const auto method =
      make_integrator(fmt::format("sts:n={},nu={},order={},step={:.17g}", n, nu, order, critical_step));
  method->prepare(chain.rhs(), unguarded_plan(chain.rhs(), {t_end}));
  method->start(0, chain.initial());
  if (!method->advance(t_end).ok()) return {lost, lost};
  const std::vector<double> end(method->state().begin(), method->state().end());
  const auto superstepped = chain.evolved([&](long double rate) {
    return std::pow(superstep_response(n, nu, rate * critical_step), static_cast<long double>(supersteps));
  });
  const auto exact = chain.evolved([&](long double rate) { return std::exp(-rate * t_end); });
  return {largest_difference(end, superstepped), largest_difference(end, exact)};
}

RoundingGrowth measure(Chain& chain, SuperstepShape shape, const std::string& order) {
  const auto [n, nu] = shape;
  const double superstep = 2 / chain.largest_rate() * superstep_length(n, nu);
  const int supersteps = std::max(1, static_cast<int>(std::ceil(run_time / superstep)));
  const ChainRun run = run_chain(chain, shape, order, supersteps);
  RoundingGrowth out;
  out.n = n;
  out.nu = nu;
  out.order = order;
  out.amplification = internal_amplification(n, nu, order);
  out.superstep_error =
      run_chain(chain, shape, order, 1).error_of_rounding / std::numeric_limits<double>::epsilon();
  out.rounding_error = run.error_of_rounding;
  out.end_error = run.error_at_end;
  out.right = run.error_of_rounding <= right_below;
  return out;
}

}  // namespace

double internal_amplification(int n, double nu, const std::string& order) {
  ThreeTermScheme scheme;
  first_order_chebyshev(n, 2 * nu / (1 - nu), scheme);
  auto substeps = superstep_substeps(n, nu);
  if (order == "leja") substeps = leja_ordered(std::move(substeps));
  const double length = superstep_length(n, nu);
  double largest = 1;
  for (int k = 0; k <= spectrum_points; ++k) {
    const double x = 2.0 * k / spectrum_points;
    largest = std::max(largest, order == "recurrence" ? largest_stage_response(scheme, x * length)
                                                      : largest_partial_product(substeps, x));
  }
  return largest;
}

std::vector<RoundingGrowth> study_rounding(bool quick) {
  const std::vector<double> dampings = quick ? std::vector{0.05, 1e-3} : std::vector{0.05, 1e-2, 1e-3};
  const std::vector<int> counts =
      quick ? std::vector{5, 20, 64, 128} : std::vector{5, 10, 15, 20, 25, 32, 50, 64, 96, 128};
  Chain chain(chain_nodes);
  std::vector<RoundingGrowth> out;
  for (const double nu : dampings)
    for (const int n : counts)
      for (const char* order : superstep_orders) out.push_back(measure(chain, {n, nu}, order));
  return out;
}

}  // namespace superstep
