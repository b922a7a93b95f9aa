#include "packing/near_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/random.hpp"

namespace superstep {
namespace {

using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

struct Cloud {
  std::vector<Vec3> centres;
  std::vector<double> radii;
};

/// Spheres at random in a cube at a relative density of 0.6; radii spread evenly in their logarithm.
Cloud random_cloud(std::size_t n, double ratio, std::uint64_t seed) {
  Random random(seed);
  Cloud cloud;
  double cubes = 0;
  for (std::size_t k = 0; k < n; ++k) {
    cloud.radii.push_back(std::pow(ratio, -random.uniform()));
    cubes += std::pow(cloud.radii.back(), 3);
  }
  const double side = std::cbrt(4.19 * cubes / 0.6);
  for (std::size_t k = 0; k < n; ++k)
    cloud.centres.push_back(
        {random.uniform(-side / 2, side / 2), random.uniform(0, side), random.uniform(side, 2 * side)});
  return cloud;
}

Pairs slow_pairs(const Cloud& cloud, double gap) {
  Pairs out;
  for (std::size_t i = 0; i < cloud.radii.size(); ++i)
    for (std::size_t j = i + 1; j < cloud.radii.size(); ++j)
      if (norm(cloud.centres[i] - cloud.centres[j]) < cloud.radii[i] + cloud.radii[j] + gap)
        out.emplace_back(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j));
  return out;
}

Pairs fast_pairs(const Cloud& cloud, double gap, std::size_t* candidates = nullptr) {
  Pairs out;
  for (const auto [i, j] : near_pairs(cloud.centres, cloud.radii, gap, candidates)) out.emplace_back(i, j);
  return out;
}

class AnySpread : public testing::TestWithParam<double> {};

TEST_P(AnySpread, FindsWhatTheSlowSearchFindsInItsOrder) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto cloud = random_cloud(1500, GetParam(), seed);
    for (const double gap : {0.0, 0.05, 1.0}) {
      const auto slow = slow_pairs(cloud, gap);
      ASSERT_GT(slow.size(), 100u);
      EXPECT_EQ(fast_pairs(cloud, gap), slow) << "seed " << seed << ", gap " << gap;
    }
  }
}

TEST_P(AnySpread, LooksAtABoundedNumberOfSpheresEach) {
  std::size_t few = 0, many = 0;
  (void)fast_pairs(random_cloud(10'000, GetParam(), 1), 0.0, &few);
  (void)fast_pairs(random_cloud(80'000, GetParam(), 1), 0.0, &many);
  const double per_sphere_few = static_cast<double>(few) / 1e4,
               per_sphere_many = static_cast<double>(many) / 8e4;
  EXPECT_LT(per_sphere_many, 100.0);  // seen: 40 to 70, of which a third are the load of the hash table
  EXPECT_LT(per_sphere_many, 1.5 * per_sphere_few);  // a small cloud has relatively more empty surroundings
}

TEST_P(AnySpread, FarOutliersCostNothing) {
  auto cloud = random_cloud(5000, GetParam(), 7);
  std::size_t before = 0, after = 0;
  const auto pairs = fast_pairs(cloud, 0.0, &before);
  cloud.centres.insert(cloud.centres.end(),
                       {{1e6, 0, 0}, {1e6 + 0.5, 0, 0}, {-1e15, 3, 0}, {0, 1e25, -1e29}});
  cloud.radii.insert(cloud.radii.end(), 4, 1.0);
  auto expected = pairs;
  expected.emplace_back(5000, 5001);
  EXPECT_EQ(fast_pairs(cloud, 0.0, &after), expected);
  EXPECT_LT(after, before + before / 4);  // they may widen the coarsest cells a little
}

INSTANTIATE_TEST_SUITE_P(Ratios, AnySpread, testing::Values(1.0, 20.0, 100.0));

TEST(NearPairs, EmptyAndSingleHaveNone) {
  EXPECT_TRUE(fast_pairs({}, 0.0).empty());
  EXPECT_TRUE(fast_pairs({{{1, 2, 3}}, {1.0}}, 5.0).empty());
}

TEST(NearPairs, DenseLatticeOnCellBordersIsComplete) {
  Cloud
      cloud;  // unit cubes whose spheres overlap by a little along the axes, centres exactly on cell borders
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y)
      for (int z = 0; z < 8; ++z) {
        cloud.centres.push_back({double(x), double(y), double(z)});
        cloud.radii.push_back(0.5 + 1e-9);
      }
  EXPECT_EQ(fast_pairs(cloud, 0.0).size(), 3u * 7 * 8 * 8);
}

}  // namespace
}  // namespace superstep
