#include "bench/measure/metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace superstep {
namespace {

constexpr double rounding = 1e-12;

FieldView whole(std::size_t count) {
  return {"temperature", "K", 0, 1, count};
}

TEST(Metrics, DeviationIsRmsAndMax) {
  const std::vector<double> state = {1, 2, 3, 8}, reference = {1, 5, 3, 4};  // differences 0, 3, 0, 4
  const Deviation difference = deviation(whole(4), state, reference);
  EXPECT_DOUBLE_EQ(difference.rms, 2.5);
  EXPECT_DOUBLE_EQ(difference.max, 4);
}

TEST(Metrics, DeviationSeesItsOwnFieldOnly) {
  const std::vector<double> state = {1, 100, 2, 200}, reference = {1, 0, 5, 0};
  const Deviation difference = deviation({"potential", "V", 0, 2, 2}, state, reference);
  EXPECT_DOUBLE_EQ(difference.max, 3);
}

TEST(Metrics, OvershootIsTheLargestExcursionOnEitherSide) {
  const std::vector<double> state = {-0.5, 3, 10.25};
  EXPECT_DOUBLE_EQ(overshoot(whole(3), state, 0, 10), 0.5);
  EXPECT_DOUBLE_EQ(overshoot(whole(3), state, -1, 11), 0);
}

TEST(Metrics, BalanceComparesWhatEnteredWithWhatIsStored) {
  const std::vector<double> capacities = {2, 3}, before = {0, 1}, now = {1, 2};
  const double kept = stored(whole(2), capacities, before, now);
  EXPECT_DOUBLE_EQ(kept, 5);
  EXPECT_DOUBLE_EQ(balance(4, kept, 50).value(), -0.25);
}

TEST(Metrics, BalanceIsEmptyWhenNothingEntered) {
  EXPECT_FALSE(balance(0, 0, 50));
  EXPECT_FALSE(balance(1e-12, 0, 50)) << "rounding of the inflow is not an inflow";
  EXPECT_FALSE(balance(0, 0, 0));
  EXPECT_TRUE(balance(-1, -1, 50)) << "heat may leave";
}

TEST(Metrics, TransientEndsAtTheLastInstantFarFromTheFinalValue) {
  // The fourth instant crosses the final value; the transient goes on until the fifth.
  const std::vector<double> distance = {10, 5, 2, 0, 1, 0.05, 0.01, 0};
  EXPECT_EQ(transient_length(distance, 10), 5U);
}

TEST(Metrics, TooShortATransientTakesAllInstants) {
  const std::vector<double> distance = {10, 5, 0.05, 0};
  EXPECT_EQ(transient_length(distance, 10), 4U);
}

TEST(Metrics, FitOfAnExactExponentialFindsItsRate) {
  std::vector<double> time, error;
  for (int k = 1; k <= 40; ++k) {
    time.push_back(1e-3 + k * 1e-6);
    error.push_back(0.3 * std::exp(-5000 * time.back()));
  }
  const auto fit = fit_decay(time, error);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->rate, 5000, 5000 * 1e-9);  // cancellation in t - mean(t) costs some digits
  EXPECT_NEAR(fit->r2.value(), 1, rounding);
}

TEST(Metrics, FitLeavesZerosOut) {
  const std::vector<double> time = {0, 1, 2, 3}, error = {1, 0, std::exp(-2.0), std::exp(-3.0)};
  const auto fit = fit_decay(time, error);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->rate, 1, rounding);
}

TEST(Metrics, FitNeedsThreePoints) {
  const std::vector<double> time = {0, 1, 2}, error = {1, 0, 0.1};
  EXPECT_FALSE(fit_decay(time, error));
}

TEST(Metrics, EqualErrorsDecayAtRateZeroAndHaveNoR2) {
  const std::vector<double> time = {0, 1, 2}, error = {0.25, 0.25, 0.25};
  const auto fit = fit_decay(time, error);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->rate, 0);
  EXPECT_FALSE(fit->r2);
}

}  // namespace
}  // namespace superstep
