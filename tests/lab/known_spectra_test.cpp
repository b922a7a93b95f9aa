/// Growth measured where every mode is known beforehand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bench/lab/frozen/limits.hpp"
#include "bench/lab/frozen/spectrum.hpp"
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

/// Where one looks at the stiff end alone, nothing is said about what rises far from it.
TEST(KnownSpectrum, OfALargeOneNoRateIsCalledZeroUnseen) {
  constexpr std::size_t most = most_for_all_eigenvalues + 20;
  const Problem problem(test::chain(most + 2));
  std::vector<double> rates;
  for (std::size_t k = 1; k < most; ++k) rates.push_back(-1e6 * static_cast<double>(k) / most);
  rates.push_back(3);
  auto hidden = unmixed(problem, rates, 1e3, 1);
  const auto state = find_limits(hidden, true);
  EXPECT_EQ(state.found_by, "Arnoldi");
  EXPECT_TRUE(std::isnan(state.rising)) << state.rising;
  EXPECT_EQ(state.limits[0].verdict, FrozenLimit::Verdict::agrees);
  rates.back() = 2e6;
  auto seen = unmixed(problem, rates, 1e3, 1);
  EXPECT_NEAR(find_limits(seen, true).rising, 2e6, 2e4);
}

}  // namespace
}  // namespace superstep
