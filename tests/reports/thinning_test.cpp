#include "results/thinning.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace superstep {
namespace {

TEST(Thinning, EvenlyKeepsTheEndsAndNothingTwice) {
  EXPECT_EQ(evenly_thinned(0, 5).size(), 0U);
  EXPECT_EQ(evenly_thinned(1, 5), (std::vector<std::size_t>{0}));
  EXPECT_EQ(evenly_thinned(5, 5), (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  const auto kept = evenly_thinned(1'000'000, 400);
  ASSERT_EQ(kept.size(), 400U);
  EXPECT_EQ(kept.front(), 0U);
  EXPECT_EQ(kept.back(), 999'999U);
  for (std::size_t k = 1; k < kept.size(); ++k) EXPECT_LT(kept[k - 1], kept[k]);
}

TEST(Thinning, RandomlyKeepsAllOrThatManyWithoutAPattern) {
  EXPECT_EQ(randomly_thinned(3, 5), (std::vector<std::size_t>{0, 1, 2}));
  const auto kept = randomly_thinned(20'000, 4000);
  ASSERT_EQ(kept.size(), 4000U);
  EXPECT_EQ(kept, randomly_thinned(20'000, 4000));
  for (std::size_t k = 1; k < kept.size(); ++k) EXPECT_LT(kept[k - 1], kept[k]);
  // Of every residue modulo 5 one expects 800; 4 standard deviations of a draw without replacement are 90.
  for (std::size_t residue = 0; residue < 5; ++residue)
    EXPECT_NEAR(static_cast<double>(
                    std::count_if(kept.begin(), kept.end(), [&](std::size_t k) { return k % 5 == residue; })),
                800, 90);
}

}  // namespace
}  // namespace superstep
