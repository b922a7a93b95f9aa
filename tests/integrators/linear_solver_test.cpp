/// The solvers of implicit methods against each other, and which one is taken.

#include <gtest/gtest.h>

#include <cmath>

#include "integrators/detail/implicit/shifted_solver.hpp"
#include "integrators/registry.hpp"
#include "support/band.hpp"
#include "support/problem.hpp"

namespace superstep {
namespace {

using test::Problem;

/// Largest |(I - c J) x - b| over the largest |b|, with J x from the sweep.
double residual(Problem& problem, double c, std::span<const double> x, std::span<const double> b) {
  std::vector<double> image(x.size());
  problem.rhs->linear_stage({.y1 = x.data(), .a = 1, .d = -c}, image);
  double worst = 0, scale = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    worst = std::max(worst, std::abs(image[i] - b[i]));
    scale = std::max(scale, std::abs(b[i]));
  }
  return worst / scale;
}

class EveryLinearSolver : public testing::TestWithParam<const char*> {};

TEST_P(EveryLinearSolver, LeavesNoResidual) {
  for (const std::uint64_t seed : {1U, 2U}) {
    Problem problem(
        test::random_graph({.nodes = 300, .seed = seed, .contrast = 1e4, .fixed = seed == 1 ? 2U : 0U}));
    const auto solver = make_shifted_solver(GetParam(), *problem.rhs);
    std::vector<double> b(problem.rhs->size()), x(b.size());
    for (std::size_t i = 0; i < b.size(); ++i) b[i] = std::sin(static_cast<double>(i * i));
    for (const double c : {1e-3, 10.0, 10.0, 1e-6}) {  // larger, the same again, smaller
      ASSERT_TRUE(solver->set(c, 0, problem.initial));
      ASSERT_TRUE(solver->solve(b, x, 1e-12));
      EXPECT_LT(residual(problem, c, x, b), 1e-9) << "c = " << c;
    }
    if (std::string(GetParam()) != "pcg") {
      EXPECT_EQ(solver->factorizations(), 3U);  // not for the same c again
    }
    EXPECT_EQ(solver->solves(), 4U);
  }
}

INSTANTIATE_TEST_SUITE_P(Solvers, EveryLinearSolver, testing::Values("klu", "cholmod", "pcg"),
                         [](const auto& solver) { return std::string(solver.param); });

TEST(LinearSolverChoice, FollowsSizeAndSymmetry) {
  Problem small(test::chain(50)), large(test::band(false, false)), radiating(test::band(true, false));
  EXPECT_EQ(fastest_linear_solver(*small.rhs), "klu");
  EXPECT_EQ(fastest_linear_solver(*large.rhs), "pcg");
  EXPECT_EQ(fastest_linear_solver(*radiating.rhs), "cholmod");  // symmetric, but no product with J alone
  EXPECT_EQ(fastest_klu_ordering(*small.rhs), "amd");
  EXPECT_EQ(fastest_klu_ordering(*large.rhs), "metis");
}

TEST(LinearSolverChoice, IsSaidAndMatchesTheNamedSolver) {
  for (const auto& [spec, named, said] :
       {std::tuple{"cvode:rtol=1e-6", "cvode:rtol=1e-6,linsol=klu,ordering=amd", "linsol=klu,ordering=amd"},
        std::tuple{"cvode:rtol=1e-6,linsol=auto", "cvode:rtol=1e-6,linsol=klu,ordering=auto",
                   "linsol=klu,ordering=amd"},
        std::tuple{"trapezoidal:rtol=1e-4", "trapezoidal:rtol=1e-4,solver=klu", "solver=klu"}}) {
    Problem problem(test::random_graph({.nodes = 80, .seed = 4}));
    const auto plan = problem.plan({1.0});
    const auto automatic = make_integrator(spec);
    automatic->prepare(*problem.rhs, plan);
    EXPECT_EQ(automatic->choice(), said);
    EXPECT_EQ(test::run(spec, problem, {0.3, 1.0}).states, test::run(named, problem, {0.3, 1.0}).states);
  }
}

TEST(LinearSolverChoice, CholmodTakesRadiation) {
  Problem problem(test::band(true, false));
  const auto cholmod = test::run("cvode:rtol=1e-7,linsol=cholmod", problem, {0.02});
  const auto klu = test::run("cvode:rtol=1e-7,linsol=klu", problem, {0.02});
  ASSERT_TRUE(cholmod.outcome.ok()) << cholmod.outcome.reason;
  EXPECT_LT(test::max_difference(cholmod.states[0], klu.states[0]), 1e-5);
}

}  // namespace
}  // namespace superstep
