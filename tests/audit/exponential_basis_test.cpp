/// The bases of the exponential on random networks of every contrast, against dense eigenvectors in extended
/// precision: no tolerance is missed, and no bound is wrong.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "audit/oracle/dense_network.hpp"
#include "integrators/registry.hpp"
#include "support/problem.hpp"

namespace superstep::audit {
namespace {

using test::Problem;
using Real = long double;

/// States at `times` [s].
std::vector<std::vector<double>> exact_states(const Problem& problem, const std::vector<double>& times) {
  const auto& graph = problem.graph;
  const auto& rows = problem.rhs->network().row_of_node;
  const std::size_t n = problem.rhs->size();
  std::vector<Real> weight(n * n, 0), outward(n, 0), load(n, 0);
  std::vector<Real> capacity(problem.rhs->capacities().begin(), problem.rhs->capacities().end());
  const auto row = [&](std::int64_t node) { return rows[static_cast<std::size_t>(node)]; };
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    if (rows[node] >= 0) load[static_cast<std::size_t>(rows[node])] += graph.source[node];
  for (std::size_t k = 0; k < graph.edges(); ++k)
    for (const auto& [from, to] : {std::pair(graph.i[k], graph.j[k]), std::pair(graph.j[k], graph.i[k])}) {
      if (row(from) < 0) continue;
      const auto own = static_cast<std::size_t>(row(from));
      if (row(to) >= 0) {
        weight[own * n + static_cast<std::size_t>(row(to))] += graph.conductance[k];
      } else {
        outward[own] += graph.conductance[k];
        load[own] += Real{graph.conductance[k]} * graph.fixed_value[static_cast<std::size_t>(to)];
      }
    }
  const auto modes = find_modes(NetworkFactor(weight, outward, capacity), capacity);
  std::vector<std::vector<double>> states;
  for (const double t : times) {
    std::vector<Real> y(n, 0);
    for (std::size_t m = 0; m < n; ++m) {
      const Real* vector = modes.vector.data() + m * n;
      Real start = 0, drive = 0;
      for (std::size_t i = 0; i < n; ++i) {
        start += vector[i] * std::sqrt(capacity[i]) * problem.initial[i];
        drive += vector[i] * load[i] / std::sqrt(capacity[i]);
      }
      const auto decayed = phi(Real(modes.rate[m] * t));
      const Real now = decayed.decay * start + t * decayed.one * drive;
      for (std::size_t i = 0; i < n; ++i) y[i] += vector[i] * now;
    }
    auto& state = states.emplace_back();
    for (std::size_t i = 0; i < n; ++i) state.push_back(static_cast<double>(y[i] / std::sqrt(capacity[i])));
  }
  return states;
}

class EveryBasis : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Exponential, EveryBasis, ::testing::Values("auto", "lanczos", "shift-invert"),
                         [](const auto& basis) { return basis.param[0] == 's' ? "inverse" : basis.param; });

TEST_P(EveryBasis, KeepsItsToleranceAtEveryContrast) {
  std::mt19937_64 random(20);
  const auto decades = [&](double low, double high) {
    return std::pow(10.0, std::uniform_real_distribution<double>(low, high)(random));
  };
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const double contrast = decades(0, 12), of_capacities = decades(0, seed % 3 == 0 ? 8 : 2);
    Graph graph = test::random_graph({.nodes = 20 + seed,
                                      .seed = seed,
                                      .contrast = contrast,
                                      .fixed = seed % 4,  // none: closed networks and their heat
                                      .sources = seed % 5 == 0});
    for (double& capacity : graph.capacity)
      capacity = std::pow(of_capacities, std::uniform_real_distribution<double>(0, 1)(random));
    Problem problem(graph);
    const double end = decades(-4, 2);
    const std::vector<double> times{end * decades(-3, 0), end};
    const auto exact = exact_states(problem, times);
    FieldRange range;
    for (const auto& values : {problem.initial, exact[0], exact[1]})
      for (const double value : values) range.take(value);
    for (std::size_t k = 0; k < graph.nodes(); ++k)
      if (graph.is_fixed[k]) range.take(graph.fixed_value[k]);
    for (const double rtol : {1e-2, 1e-4, 1e-6, 1e-9}) {
      // Lanczos rounds by epsilons of rho for the whole time: `auto` leaves it alone beyond this.
      const double t_rho = end * problem.rhs->spectral_bound(0, problem.initial);
      constexpr double roundings = 30 * std::numeric_limits<double>::epsilon();
      const bool beyond_lanczos = GetParam() == std::string("lanczos") && roundings * t_rho > rtol;
      const auto integrator =
          make_integrator(fmt::format("exponential:basis={},rtol={:g}", GetParam(), rtol));
      Plan plan = problem.plan(times);
      plan.spans = {range.span()};
      integrator->prepare(*problem.rhs, plan);
      integrator->start(0, problem.initial);
      double error = 0;
      for (std::size_t k = 0; k < times.size(); ++k) {
        ASSERT_TRUE(integrator->advance(times[k]).ok()) << seed;
        const auto state = integrator->state();
        error = std::max(error, test::rms_difference({state.begin(), state.end()}, exact[k]) / range.span());
      }
      const double bound = integrator->statistics().error_bound;
      const auto scene = fmt::format("seed {}, contrast {:.1e}, rtol {:g}", seed, contrast, rtol);
      EXPECT_TRUE(beyond_lanczos || error <= rtol) << scene << ": " << error;
      EXPECT_TRUE(bound == 0 || error <= bound) << scene << ": " << error << " above " << bound;
    }
  }
}

}  // namespace
}  // namespace superstep::audit
