/// Single nodes whose temperature is known in closed form.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "integrators/registry.hpp"
#include "support/problem.hpp"

namespace superstep {
namespace {

TEST(Radiation, OfOneNodeHasItsClosedForm) {
  // dT/dt = -r T^4 into a void of 0 K: T = T0 (1 + 3 r T0^3 t)^(-1/3).
  Graph graph = test::chain(1);
  graph.initial = {2.0};
  graph.radiation.push_back({0, 0.1, 0.0, -1});
  test::Problem problem(graph);
  for (const char* spec : {"rkc:rtol=1e-8", "rock:rtol=1e-8", "cvode:rtol=1e-9", "trapezoidal:rtol=1e-8"}) {
    const auto result = test::run(spec, problem, {1.0, 5.0});
    ASSERT_TRUE(result.outcome.ok()) << spec << ": " << result.outcome.reason;
    EXPECT_NEAR(result.states[0][0], 2.0 * std::cbrt(1 / (1 + 0.3 * 8 * 1)), 6e-6)
        << spec;  // 1e-8 of 2 in each of some 300 steps
    EXPECT_NEAR(result.states[1][0], 2.0 * std::cbrt(1 / (1 + 0.3 * 8 * 5)), 6e-6) << spec;
  }
}

TEST(Convection, OfOneNodeHasItsClosedForm) {
  // C dT/dt = h A (T_inf - T): exponential relaxation; T_inf = a + b t lags behind by b C/(h A).
  Graph graph = test::chain(1);
  graph.initial = {1.0};
  graph.convection.push_back({0, 0.5, 3.0, -1});
  test::Problem constant(graph);
  for (const char* spec : {"exponential:rtol=1e-12", "rkc:rtol=1e-9", "cvode:rtol=1e-10"}) {
    const auto result = test::run(spec, constant, {2.0});
    ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
    EXPECT_NEAR(result.states[0][0], 3.0 - 2.0 * std::exp(-1.0), 6e-7)
        << spec;  // 1e-9 of 2 in each of some 300 steps
  }
  graph.tables.push_back({{0, 10}, {3, 13}});
  graph.convection[0].table = 0;
  test::Problem rising(graph);
  for (const char* spec : {"rkc:rtol=1e-9", "rock:rtol=1e-9", "cvode:rtol=1e-10"}) {
    const auto result = test::run(spec, rising, {4.0});
    ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
    // T = 3 + t - 2 + c exp(-t/2), T(0) = 1 gives c = 0
    EXPECT_NEAR(result.states[0][0], 5.0, 1e-7) << spec;
  }
}

TEST(TabledSource, OfManyKnotsKeepsTheToleranceOverAllFreshStarts) {
  // An insulated node at 300 K: nothing decays. The source always rises, so the errors of all starts have one
  // sign; the heat is the sum of trapezoids, 2 J in all.
  Graph graph = test::chain(1);
  graph.initial = {300.0};
  TimeTable source{{0}, {0}};
  for (int k = 1; k <= 70; ++k) {
    source.time.push_back(k);
    source.value.push_back(source.value.back() + (k % 2 == 0 ? 2.0 : 1.0));
  }
  double joules = 0;
  for (std::size_t k = 0; k < 70; ++k) joules += (source.value[k] + source.value[k + 1]) / 2;
  for (double& value : source.value) value *= 2 / joules;
  graph.tables.push_back(source);
  graph.tabled_sources.push_back({.node = 0, .table = 0});
  test::Problem problem(graph);
  Plan plan = problem.plan({70.0});
  plan.ranges = {{.low = 300, .high = 302}};
  const double capacity = graph.capacity[0];
  for (const double rtol : {1e-3, 1e-5}) {
    const auto method = make_integrator(fmt::format("cvode:rtol={}", rtol));
    method->prepare(*problem.rhs, plan);
    method->start(0, problem.initial);
    ASSERT_TRUE(method->advance(70.0).ok());
    EXPECT_NEAR(method->state()[0], 300 + 2 / capacity, 5 * rtol * 2 / capacity) << rtol;
  }
}

}  // namespace
}  // namespace superstep
