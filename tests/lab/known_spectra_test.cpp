/// Growth measured where every mode is known beforehand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bench/lab/frozen/limits.hpp"
#include "support/problem.hpp"

namespace superstep {
namespace {

using test::Problem;

/// Modes that do not mix: a real one for each rate, and a turning pair -a +- ib.
FrozenRhs unmixed(const Problem& problem, const std::vector<double>& rates, double a, double b) {
  const std::size_t real = rates.size(), n = real + 2;
  FrozenJacobian jacobian;
  jacobian.pattern.column_begin = {0};
  for (std::size_t j = 0; j < n; ++j) {
    const auto entry = [&](std::size_t i, double value) {
      if (i == j) jacobian.pattern.diagonal.push_back(static_cast<int>(jacobian.values.size()));
      jacobian.pattern.row.push_back(static_cast<int>(i));
      jacobian.values.push_back(value);
    };
    if (j < real) {
      entry(j, rates[j]);
    } else {
      entry(real, j == real ? -a : b);
      entry(real + 1, j == real ? -b : -a);
    }
    jacobian.pattern.column_begin.push_back(static_cast<int>(jacobian.values.size()));
  }
  jacobian.weights.assign(n, 1.0);
  jacobian.bound = a + b;
  for (const double rate : rates) jacobian.bound = std::max(jacobian.bound, std::abs(rate));
  jacobian.traits = {.linear = true, .constant_jacobian = true, .symmetric = false, .autonomous = true};
  return {*problem.rhs, std::move(jacobian)};
}

TEST(KnownSpectrum, AModeThatIsNotTheStiffestLimitsAStep) {
  const Problem problem(test::chain(6));
  ASSERT_EQ(problem.rhs->size(), 6U);
  auto rhs = unmixed(problem, {-10, -3, -2, -1}, 1, 7);
  const auto state = find_limits(rhs, true);
  EXPECT_NEAR(*state.limits[0].predicted, 2.0 / 50, 1e-12) << "the stiffest one alone: 0.2";
  EXPECT_NEAR(state.limits[0].measured, 2.0 / 50, 2e-4 * 2 / 50);
  EXPECT_EQ(state.limits[0].verdict, FrozenLimit::Verdict::agrees);
  auto without = unmixed(problem, {-10, -3, -2, -1}, 1, 0);
  const auto real = find_limits(without, true);
  for (std::size_t k = 0; k < state.limits.size(); ++k)
    EXPECT_LT(state.limits[k].measured, 0.9 * real.limits[k].measured) << state.limits[k].spec;
}

TEST(KnownSpectrum, SeveralThatGrowByThemselvesDoNotCountAgainstAStep) {
  const Problem problem(test::chain(6));
  auto rhs = unmixed(problem, {-100, 40, 20, 5}, 30, 1);
  const auto state = find_limits(rhs, true);
  EXPECT_NEAR(state.rising, 40, 1e-12);
  EXPECT_NEAR(*state.limits[0].predicted, 0.02, 1e-12);
  EXPECT_NEAR(state.limits[0].measured, 0.02, 2e-4 * 0.02);
  for (const auto& limit : state.limits) EXPECT_GE(limit.measured, 0.02 * (1 - 1e-3)) << limit.spec;
}

}  // namespace
}  // namespace superstep
