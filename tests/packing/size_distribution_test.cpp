#include "packing/relaxation/size_distribution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace superstep {
namespace {

SizeDistribution lognormal(double median, double sigma, double min, double max) {
  SizeDistribution sizes;
  sizes.kind = SizeDistribution::Kind::lognormal;
  sizes.median = median;
  sizes.sigma = sigma;
  sizes.min = min;
  sizes.max = max;
  return sizes;
}

TEST(StratifiedDiameters, LognormalHasItsMedianItsSpreadAndItsCutOffs) {
  const auto d = stratified_diameters(lognormal(4e-6, 0.4, 4e-8, 4e-4), 10001);  // cut-offs 11 sigma away
  EXPECT_TRUE(std::is_sorted(d.begin(), d.end()));
  EXPECT_EQ(d.front(), 4e-8);
  EXPECT_EQ(d.back(), 4e-4);
  EXPECT_NEAR(d[5000] / 4e-6, 1.0, 1e-6);
  // Quantiles of the normal distribution at +-1: 0.158655, 0.841345; their place is known to half a stratum.
  EXPECT_NEAR(std::log(d[1586] / 4e-6) / 0.4, -1.0, 1e-3);
  EXPECT_NEAR(std::log(d[8414] / 4e-6) / 0.4, 1.0, 1e-3);
}

TEST(StratifiedDiameters, UniformFillsItsRangeEvenly) {
  SizeDistribution sizes;
  sizes.min = 1;
  sizes.max = 3;
  EXPECT_EQ(stratified_diameters(sizes, 4), (std::vector<double>{1.25, 1.75, 2.25, 2.75}));
}

TEST(StratifiedDiameters, ListFollowsItsWeights) {
  SizeDistribution sizes;
  sizes.kind = SizeDistribution::Kind::list;
  sizes.diameters = {3, 1, 2};
  EXPECT_EQ(stratified_diameters(sizes, 3), (std::vector<double>{1, 2, 3}));
  sizes.weights = {1, 4, 5};
  const auto d = stratified_diameters(sizes, 1000);
  EXPECT_EQ(std::count(d.begin(), d.end(), 1.0), 400);
  EXPECT_EQ(std::count(d.begin(), d.end(), 2.0), 500);
  EXPECT_EQ(std::count(d.begin(), d.end(), 3.0), 100);
}

TEST(MedianForVolume, HitsTheVolumeEvenWithStrongCutOffs) {
  for (const double sigma : {0.2, 0.5, 1.5}) {
    auto sizes = lognormal(0, sigma, 1.5e-6, 20e-6);
    constexpr double volume = 3e-13;  // mean diameter 8.3 um
    sizes.median = median_for_volume(sizes, 1000, volume);
    EXPECT_NEAR(volume_of_diameters(stratified_diameters(sizes, 1000)) / volume, 1.0, 1e-9) << sigma;
  }
}

TEST(MedianForVolume, RefusesAVolumeOutOfReach) {
  EXPECT_THROW((void)median_for_volume(lognormal(0, 0.5, 1e-6, 2e-6), 100, 1.0), UsageError);
}

TEST(CountForVolume, ComesClosest) {
  const auto sizes = lognormal(4e-6, 0.5, 1.5e-6, 20e-6);
  const double volume = 1e-12;
  const auto n = count_for_volume(sizes, volume, 1'000'000);
  const double miss = std::abs(volume_of_diameters(stratified_diameters(sizes, n)) - volume);
  EXPECT_LT(miss / volume, 1.0 / static_cast<double>(n));
  EXPECT_THROW((void)count_for_volume(sizes, volume, 100), UsageError);
}

}  // namespace
}  // namespace superstep
