/// Bodies that lose no heat, of good and bad conductors: what all values share moves a million times slower
/// than what they do not, and must not be lost in iterations.

#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <numeric>

#include "support/problem.hpp"

namespace superstep {
namespace {

constexpr std::size_t side = 6, nodes = side * side * side;
constexpr double t_end = 1e3;  // ten thousand million times what the fastest exchange takes

/// A lattice of capacities 1, three of four nodes a million times the better conductor; three are heated.
Graph insulated_lattice() {
  Graph graph;
  const auto conductivity = [](std::size_t k) { return k * 7919 % 4 == 0 ? 1.0 : 1e6; };
  for (std::size_t k = 0; k < nodes; ++k) {
    graph.id.push_back(static_cast<std::int64_t>(k));
    graph.capacity.push_back(1);
    graph.source.push_back(k == 5 || k == 100 || k == 200 ? 1 : 0);
    graph.initial.push_back(300);
    graph.is_fixed.push_back(0);
    graph.fixed_value.push_back(0);
    const std::array<std::size_t, 3> at = {k % side, k / side % side, k / (side * side)};
    for (std::size_t axis = 0, step = 1; axis < 3; ++axis, step *= side) {
      if (at[axis] + 1 == side) continue;
      const double a = conductivity(k), b = conductivity(k + step);
      graph.i.push_back(static_cast<std::int32_t>(k));
      graph.j.push_back(static_cast<std::int32_t>(k + step));
      graph.conductance.push_back(2 * a * b / (a + b));
    }
  }
  return graph;
}

class Insulated : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Iterations, Insulated,
                         testing::Values("cvode:rtol=1e-4,linsol=gmres", "cvode:rtol=1e-4,linsol=pcg",
                                         "arkode:rtol=1e-4,linsol=gmres", "petsc:rtol=1e-4,linsol=gmres",
                                         "esdirk:rtol=1e-4,solver=pcg", "exprb:rtol=1e-4", "auto:rtol=1e-4"),
                         [](const auto& spec) {
                           std::string name = spec.param;
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

TEST_P(Insulated, BodiesKeepTheHeatThatEntersThem) {
  test::Problem problem(insulated_lattice());
  const auto run = test::run(GetParam(), problem, {t_end});
  if (run.outcome.status == Status::refused) GTEST_SKIP() << run.outcome.reason;
  ASSERT_TRUE(run.outcome.ok()) << run.outcome.reason;
  const auto& end = run.states.back();
  const double mean = std::accumulate(end.begin(), end.end(), 0.0) / static_cast<double>(nodes);
  const double expected = 300 + 3 * t_end / static_cast<double>(nodes);
  EXPECT_NEAR(mean, expected, 3e-4 * (expected - 300));
  EXPECT_LT(run.statistics.steps, 2000U);
}

}  // namespace
}  // namespace superstep
