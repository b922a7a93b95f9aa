/// Iterations behind hypre's multigrid against the other solvers of PETSc, on systems of every kind. Skipped
/// where PETSc was not found, or was built without hypre.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "integrators/registry.hpp"
#include "support/problem.hpp"
#include "support/thermoelectric.hpp"

namespace superstep {
namespace {

bool has_petsc() {
  const auto& all = integrators();
  return std::any_of(all.begin(), all.end(), [](const auto& entry) { return entry.name == "petsc"; });
}

class Multigrid : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_petsc()) GTEST_SKIP() << "built without PETSc";
    test::Problem problem(test::chain(5, 0.0, 1.0));
    const auto outcome = test::run("petsc:linsol=hypre", problem, {1.0}).outcome;
    if (outcome.status == Status::refused) GTEST_SKIP() << outcome.reason;
  }
};

/// A cubic lattice whose bottom is held at 0 and whose top at 1, from 0.
Graph lattice(std::size_t across, std::size_t high, double contrast) {
  Graph graph;
  const std::size_t layer = across * across;
  const auto conductivity = [&](std::size_t k) {
    return std::pow(contrast, static_cast<double>(k * 7919 % 101) / 100);
  };
  for (std::size_t k = 0; k < layer * high; ++k) {
    const bool top = k >= layer * (high - 1);
    graph.id.push_back(static_cast<std::int64_t>(k));
    graph.capacity.push_back(1 + 0.1 * static_cast<double>(k % 7));
    graph.source.push_back(0);
    graph.initial.push_back(0);
    graph.is_fixed.push_back(top || k < layer);
    graph.fixed_value.push_back(top ? 1 : 0);
    const std::array<std::size_t, 3> at = {k % across, k / across % across, k / layer};
    const std::array<std::size_t, 3> end = {across, across, high};
    for (std::size_t axis = 0, step = 1; axis < 3; ++axis, step *= across) {
      if (at[axis] + 1 == end[axis]) continue;
      const double a = conductivity(k), b = conductivity(k + step);
      graph.i.push_back(static_cast<std::int32_t>(k));
      graph.j.push_back(static_cast<std::int32_t>(k + step));
      graph.conductance.push_back(2 * a * b / (a + b));
    }
  }
  return graph;
}

/// Errors at the end, of runs that are to keep 1e-6 of the span.
constexpr const char* multigrid = "petsc:rtol=1e-6,linsol=hypre";
constexpr double allowed = 3e-6;  // differences of states that are near it for good

TEST_F(Multigrid, SolvesAChainAndALattice) {
  test::Problem chain(test::chain(400, 0.0, 1.0)), cube(lattice(6, 8, 1));
  for (auto* problem : {&chain, &cube}) {
    const auto found = test::run(multigrid, *problem, {1.0, 1e3});
    ASSERT_TRUE(found.outcome.ok()) << found.outcome.reason;
    EXPECT_LT(test::rms_difference(found.states[0], problem->exact(1.0)), allowed);
    EXPECT_LT(test::rms_difference(found.states[1], problem->exact(1e3)), allowed);
  }
}

TEST_F(Multigrid, SolvesWhatIsAMillionTimesStiffer) {
  test::Problem cube(lattice(7, 8, 1e6));
  const auto exact = cube.exact(0.5);
  for (const char* method : {"bdf", "rosw"}) {
    const auto found = test::run(std::string(multigrid) + ",method=" + method, cube, {0.01, 0.5});
    ASSERT_TRUE(found.outcome.ok()) << found.outcome.reason;
    EXPECT_LT(test::rms_difference(found.states[1], exact), allowed) << method;
  }
}

/// Steps of a system of which everything but the solver is the same.
TEST_F(Multigrid, TakesTheStepsOfADirectSolver) {
  test::Problem cube(lattice(10, 12, 1e3));
  const auto one = test::run(multigrid, cube, {1.0}),
             other = test::run("petsc:rtol=1e-6,linsol=cholesky", cube, {1.0});
  ASSERT_TRUE(one.outcome.ok() && other.outcome.ok()) << one.outcome.reason;
  EXPECT_NEAR(static_cast<double>(one.statistics.steps), static_cast<double>(other.statistics.steps), 2);
  EXPECT_LT(test::rms_difference(one.states[0], other.states[0]), 1e-7);
}

TEST_F(Multigrid, SolvesConductivitiesThatFollowTheTemperature) {
  const ConductivityLaw law{.kind = ConductivityLaw::Kind::linear, .value = 2, .coefficient = 0.5};
  const auto rhs =
      test::Thermoelectric{
          .nodes = 120, .thermal = {law, {.value = 1}}, .convection = true, .radiation = true}
          .build();
  const std::vector<double> times = {1.0, 15.0};
  const auto one = test::run_coupled(*rhs, multigrid, times, {0, 1}),
             other = test::run_coupled(*rhs, "petsc:rtol=1e-7,order=5,linsol=lu", times, {0, 1});
  ASSERT_TRUE(one.outcome.ok()) << one.outcome.reason;
  ASSERT_TRUE(other.outcome.ok()) << other.outcome.reason;
  EXPECT_LT(test::rms_difference(one.states[1], other.states[1]), 10 * allowed);
}

TEST_F(Multigrid, SolvesTwoFieldsThatActOnEachOther) {
  const ConductivityLaw law{.kind = ConductivityLaw::Kind::linear, .value = 3, .coefficient = 0.5};
  const auto rhs =
      test::Thermoelectric{.nodes = 120, .electric = {law, {.value = 1}}, .convection = true}.build();
  ASSERT_EQ(rhs->fields().size(), 2U);
  const std::vector<double> times = {1.0, 15.0};
  const auto one = test::run_coupled(*rhs, multigrid, times, {0, 1});
  ASSERT_TRUE(one.outcome.ok()) << one.outcome.reason;
  for (const char* solver : {"lu", "gmres"}) {
    const auto other =
        test::run_coupled(*rhs, std::string("petsc:rtol=1e-7,order=5,linsol=") + solver, times, {0, 1});
    ASSERT_TRUE(other.outcome.ok()) << other.outcome.reason;
    EXPECT_LT(test::rms_difference(one.states[1], other.states[1]), 10 * allowed) << solver;
  }
}

}  // namespace
}  // namespace superstep
