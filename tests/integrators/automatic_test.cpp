/// `auto` and the superstep that chooses itself: the tolerance is kept, and the choice is explained.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <vector>

#include "integrators/registry.hpp"
#include "support/problem.hpp"

namespace superstep {
namespace {

using test::max_difference;
using test::Problem;
using test::random_graph;
using test::run;

TEST(Automatic, DeliversTheToleranceAndSaysWhy) {
  for (const double rtol : {1e-2, 1e-4, 1e-7}) {
    Problem problem(random_graph({.nodes = 100, .seed = 8, .contrast = 1e3, .sources = true}));
    const auto integrator = make_integrator(fmt::format("auto:rtol={}", rtol));
    integrator->prepare(*problem.rhs, problem.plan({0.1, 1.0}));
    integrator->start(0, problem.initial);
    for (const double t : {0.1, 1.0}) {
      ASSERT_TRUE(integrator->advance(t).ok());
      const auto state = integrator->state();
      EXPECT_LT(test::rms_difference({state.begin(), state.end()}, problem.exact(t)), rtol)
          << integrator->choice();
    }
    const std::string choice = integrator->choice();
    EXPECT_EQ(choice.find("sweep"), choice.rfind("sweep")) << choice;
    EXPECT_LT(choice.size(), 140u) << choice;
    EXPECT_NO_THROW((void)make_integrator(choice.substr(0, choice.find(' '))))
        << "it names a SPEC: " << choice;
  }
}

TEST(Automatic, TurnsToFactorizationWhenSweepsWouldBeTooMany) {
  Graph graph = test::chain(100, 0.0, 1.0);
  graph.conductance[50] = 1e12;  // one contact twelve decades stiffer than the rest
  Problem problem(graph);
  const auto integrator = make_integrator("auto:rtol=1e-4");
  integrator->prepare(*problem.rhs, problem.plan({1000}));
  integrator->start(0, problem.initial);
  ASSERT_TRUE(integrator->advance(1000).ok());
  EXPECT_NE(integrator->choice().find("basis=shift-invert"), std::string::npos) << integrator->choice();
}

TEST(AutomaticSuperstep, StaysNearItsTolerance) {
  for (const double rtol : {3e-2, 3e-3}) {
    Problem problem(test::chain(200, 0.0, 1.0));
    const auto result = run(fmt::format("sts:n=auto,rtol={}", rtol), problem, {2000, 10000});
    ASSERT_TRUE(result.outcome.ok());
    EXPECT_LT(test::rms_difference(result.states[0], problem.exact(2000)), rtol);
    EXPECT_LT(test::rms_difference(result.states[1], problem.exact(10000)), rtol);
  }
}

}  // namespace
}  // namespace superstep
