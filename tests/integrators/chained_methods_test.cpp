/// Methods whose stages pass over a large network together must not notice it.

#include <gtest/gtest.h>

#include "support/band.hpp"
#include "support/problem.hpp"

namespace superstep {
namespace {

using test::band;
using test::small_cache;
using test::Threads;

class ChainedMethod : public testing::TestWithParam<const char*> {};

TEST_P(ChainedMethod, GivesTheSameBitsBeyondTheCache) {
  const auto with_cache = [&](std::size_t bytes, int threads) {
    const Threads as_many(threads);
    test::Problem problem(band(false, false));
    problem.rhs->assume_cache(bytes);
    return test::run(GetParam(), problem, {0.05, 0.2});
  };
  const auto expected = with_cache(std::size_t{1} << 40, 1);
  ASSERT_TRUE(expected.outcome.ok()) << expected.outcome.reason;
  for (const int threads : {1, 2}) {
    const auto got = with_cache(small_cache, threads);
    EXPECT_EQ(got.states, expected.states);
    EXPECT_EQ(got.sweeps, expected.sweeps);
    EXPECT_EQ(got.statistics.steps, expected.statistics.steps);
    EXPECT_EQ(got.statistics.inflow, expected.statistics.inflow);
    ASSERT_EQ(got.history.size(), expected.history.size());
    for (std::size_t k = 0; k < expected.history.size(); ++k) {
      EXPECT_EQ(got.history.time(k), expected.history.time(k));
      EXPECT_EQ(got.history.value(k, 0), expected.history.value(k, 0));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Explicit, ChainedMethod,
                         testing::Values("forward-euler", "sts:n=40,nu=1e-3",
                                         "sts:n=50,nu=1e-3,order=recurrence", "rkc:step=0.05,order=1",
                                         "rkc:rtol=1e-4", "rkl:rtol=1e-4", "exponential:rtol=1e-9"));

}  // namespace
}  // namespace superstep
