/// The phi rule: order, its three solvers, and the step adaptation of the sintering paper.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "integrators/registry.hpp"
#include "support/problem.hpp"

namespace superstep {
namespace {

using test::Problem;
using test::random_graph;
using test::rms_difference;
using test::run;

double measured_order(const std::string& spec, double largest_step) {
  Problem problem(random_graph({.nodes = 25, .seed = 7, .contrast = 4, .sources = true}));
  const auto exact = problem.exact(1.0);
  double coarse = 0, fine = 0;
  for (int level = 0; level < 4; ++level) {
    const auto result = run(fmt::format("{},step={}", spec, largest_step / (1 << level)), problem, {1.0});
    EXPECT_TRUE(result.outcome.ok()) << result.outcome.reason;
    coarse = fine;
    fine = rms_difference(result.states.back(), exact);
  }
  return std::log2(coarse / fine);
}

TEST(Trapezoidal, OrderIsTwoInTheMiddleAndOneElsewhere) {
  for (const char* solver : {"klu", "pcg"}) {
    EXPECT_NEAR(measured_order(fmt::format("trapezoidal:solver={}", solver), 0.02), 2, 0.1) << solver;
    EXPECT_NEAR(measured_order(fmt::format("trapezoidal:phi=1,solver={}", solver), 0.02), 1, 0.1) << solver;
  }
  EXPECT_NEAR(measured_order("trapezoidal:solver=fixed-point,rtol=1e-12,iterations=200", 0.01), 2, 0.1);
}

TEST(Trapezoidal, SolversGiveTheSameFixedSteps) {
  Problem problem(random_graph({.nodes = 60, .seed = 9, .contrast = 100, .sources = true}));
  const auto klu = run("trapezoidal:phi=0.6,step=0.001", problem, {0.05});
  for (const char* spec : {"trapezoidal:phi=0.6,step=0.001,solver=pcg",
                           "trapezoidal:phi=0.6,step=0.001,solver=fixed-point,rtol=1e-13,iterations=500"}) {
    const auto other = run(spec, problem, {0.05});
    ASSERT_TRUE(other.outcome.ok()) << other.outcome.reason;
    EXPECT_LT(test::max_difference(klu.states.back(), other.states.back()), 1e-10) << spec;
  }
}

TEST(Trapezoidal, FactorizesOncePerDistinctStep) {
  Problem problem(test::chain(50, 0.0, 1.0));
  const auto fixed = run("trapezoidal:step=10", problem, {1000});
  EXPECT_EQ(fixed.statistics.steps, 100u);
  EXPECT_EQ(fixed.statistics.factorizations, 1u);
  EXPECT_EQ(fixed.jacobians, 1u);
  const auto controlled = run("trapezoidal:rtol=1e-5", problem, {1000});
  EXPECT_LT(controlled.statistics.factorizations, controlled.statistics.steps / 2);
  EXPECT_EQ(controlled.jacobians, 1u);
}

TEST(Trapezoidal, PhiZeroIsForwardEuler) {
  Problem problem(random_graph({.nodes = 30, .seed = 2}));
  const auto euler = run("forward-euler:step=0.001", problem, {0.1});
  const auto phi = run("trapezoidal:phi=0,step=0.001", problem, {0.1});
  EXPECT_LT(test::max_difference(euler.states.back(), phi.states.back()), 1e-12);
}

TEST(FixedPoint, AdaptsItsStepAsThePaperDoes) {
  Problem problem(test::chain(40, 0.0, 1.0));  // rho = 4
  const auto exact = problem.exact(200);
  const auto result = run("trapezoidal:solver=fixed-point,rtol=1e-6", problem, {200});
  ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
  EXPECT_LT(test::max_difference(result.states.back(), exact), 1e-3);
  // It settles where about ten iterations reach the tolerance, below the contraction limit 1/(phi rho) = 0.5.
  EXPECT_GT(result.statistics.steps, 200 / 0.5);
  EXPECT_LE(result.statistics.max_stages, 10);
  // A looser tolerance needs less contraction: longer steps, hence growth from the same first step.
  const auto loose = run("trapezoidal:solver=fixed-point,rtol=1e-3", problem, {200});
  EXPECT_LT(loose.statistics.steps, result.statistics.steps);
  // Growth stops at the contraction limit by rejection and restart.
  EXPECT_GT(loose.statistics.rejected + result.statistics.rejected, 0u);
}

TEST(FixedPoint, SaysWhenContractionIsHopelessWhileTheOthersGoThrough) {
  Problem problem(test::chain(40, 0.0, 1.0));
  const auto hopeless = run("trapezoidal:solver=fixed-point,step=5", problem, {200});
  EXPECT_EQ(hopeless.outcome.status, Status::failed);
  EXPECT_NE(hopeless.outcome.reason.find("phi h rho"), std::string::npos) << hopeless.outcome.reason;
  EXPECT_NE(hopeless.outcome.reason.find("klu"), std::string::npos);
  for (const char* solver : {"klu", "pcg"})
    EXPECT_TRUE(run(fmt::format("trapezoidal:step=5,solver={}", solver), problem, {200}).outcome.ok())
        << solver;
}

TEST(FixedPoint, SaysWhenItsIterationsDoNotSuffice) {
  Problem problem(
      test::chain(40, 0.0, 1.0));  // phi h rho = 0.8: contracts, but not to 1e-10 in three iterations
  const auto result = run("trapezoidal:solver=fixed-point,rtol=1e-10,iterations=3,step=0.4", problem, {200});
  EXPECT_EQ(result.outcome.status, Status::failed);
  EXPECT_NE(result.outcome.reason.find("not converged"), std::string::npos) << result.outcome.reason;
  EXPECT_EQ(result.statistics.rejected, 1u);
}

TEST(Trapezoidal, StiffModesRingAtOneHalfAndDieAbove) {
  Graph graph = test::chain(3, 0.0, 0.0);
  graph.initial[1] = 1;
  graph.conductance = {1e6, 1e6};
  Problem problem(graph);
  const auto ringing = run("trapezoidal:step=1", problem, {10});
  EXPECT_GT(std::abs(ringing.states.back()[0]), 0.9);
  const auto damped = run("trapezoidal:step=1,phi=0.6", problem, {10});
  EXPECT_LT(std::abs(damped.states.back()[0]), 0.05);
}

TEST(Trapezoidal, RefusesKeysThatDoNotBelong) {
  EXPECT_THROW(static_cast<void>(make_integrator("trapezoidal:iterations=5")), UsageError);
  EXPECT_THROW(static_cast<void>(make_integrator("trapezoidal:phi=1.5")), UsageError);
  EXPECT_THROW(static_cast<void>(make_integrator("trapezoidal:solver=lu")), UsageError);
}

}  // namespace
}  // namespace superstep
