/// Single nodes whose temperature is known in closed form.

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace superstep
