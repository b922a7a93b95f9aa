/// Packings on a grid: the same bits everywhere.

#include "packing/grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "core/hash.hpp"

namespace superstep {
namespace {

GridSettings settings() {
  return {.count = 600,
          .spacing = 1e-3,
          .smallest = 1.0e-3,
          .largest = 1.1e-3,
          .jitter = 0.05,
          .materials = {"metal", "polymer"},
          .shares = {0.7, 0.3},
          .seed = 3};
}

std::string hash_of(const Packing& packing) {
  ContentHash hash;
  for (const auto& centre : packing.centre)
    hash.add_number(centre.x).add_number(centre.y).add_number(centre.z);
  return hash.add_all<double>(packing.radius).add_all<std::int32_t>(packing.material).text();
}

TEST(Grid, IsTheCommittedBits) {  // of every compiler and machine
  EXPECT_EQ(hash_of(grid_packing(settings())), "d289115b8529bd1f935e998453d2bb54");
}

TEST(Grid, IsTheLargestCubeThatFits) {
  EXPECT_EQ(grid_packing(settings()).size(), 512u);
}

TEST(Grid, KeepsSizesAndShares) {
  const auto packing = grid_packing(settings());
  for (const double radius : packing.radius) {
    EXPECT_GE(radius, 0.5e-3);
    EXPECT_LE(radius, 0.55e-3);
  }
  const auto polymer = std::count(packing.material.begin(), packing.material.end(), 1);
  EXPECT_NEAR(static_cast<double>(polymer) / 512, 0.3, 0.08);  // four standard deviations
}

}  // namespace
}  // namespace superstep
