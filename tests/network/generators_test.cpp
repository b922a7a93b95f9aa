/// Generated networks: the same bits everywhere, and what they promise.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "network/components.hpp"
#include "network/generators/exact.hpp"
#include "network/generators/network_generator.hpp"

namespace superstep {
namespace {

NetworkRecipe recipe_for(const NetworkGenerator& generator) {
  return {.size = 500,
          .contrast = 1e6,
          .spread = 1e3,
          .fraction = generator.fraction.empty() ? 0 : 0.3,
          .seed = 7};
}

class EveryGenerator : public testing::TestWithParam<std::string> {
 protected:
  const NetworkGenerator& generator_ = *find_network_generator(GetParam());
  NetworkRecipe recipe_ = recipe_for(generator_);
};

std::vector<std::string> names() {
  std::vector<std::string> out;
  for (const auto& generator : network_generators()) out.push_back(generator.name);
  return out;
}

INSTANTIATE_TEST_SUITE_P(Table, EveryGenerator, testing::ValuesIn(names()),
                         [](const auto& name) { return name.param; });

/// Every compiler, every machine and every instruction set must make these.
const std::map<std::string, std::string>& committed() {
  static const std::map<std::string, std::string> hashes = {
#include "generator_hashes.inc"
  };
  return hashes;
}

TEST_P(EveryGenerator, MakesTheCommittedBits) {
  const auto expected = committed().find(GetParam());
  ASSERT_NE(expected, committed().end()) << "write it down: " << network_hash(generator_.make(recipe_));
  EXPECT_EQ(network_hash(generator_.make(recipe_)), expected->second);
}

TEST_P(EveryGenerator, MakesAnotherNetworkOfAnotherSeedOnlyIfItDrawsNumbers) {
  const std::string first = network_hash(generator_.make(recipe_));
  recipe_.seed = 8;
  EXPECT_EQ(network_hash(generator_.make(recipe_)) == first, GetParam() == "ladder");
}

TEST_P(EveryGenerator, HasTheSizeAndNoEdgeTwice) {
  const auto made = generator_.make(recipe_);
  const auto& graph = made.graph;
  EXPECT_LE(graph.nodes(), recipe_.size);
  EXPECT_GE(graph.nodes(), recipe_.size / 2);
  std::set<std::pair<std::int32_t, std::int32_t>> seen;
  for (std::size_t k = 0; k < graph.edges(); ++k) {
    EXPECT_LT(graph.i[k], graph.j[k]);
    EXPECT_TRUE(seen.emplace(graph.i[k], graph.j[k]).second) << graph.i[k] << " " << graph.j[k];
  }
  EXPECT_FALSE(made.inlet.empty());
  EXPECT_FALSE(made.outlet.empty());
  EXPECT_FALSE(made.heated.empty());
}

TEST_P(EveryGenerator, KeepsItsContrasts) {
  const auto graph = generator_.make(recipe_).graph;
  const auto [low, high] = std::minmax_element(graph.conductance.begin(), graph.conductance.end());
  const auto [small, large] = std::minmax_element(graph.capacity.begin(), graph.capacity.end());
  EXPECT_GT(*low, 0);
  // Spheres scale by radii and necks, trees by a factor of two within a level; ends need not be drawn.
  EXPECT_LE(*high / *low, 1e3 * recipe_.contrast);
  EXPECT_GE(*high / *low, 1e-2 * recipe_.contrast);
  EXPECT_LE(*large / *small, recipe_.spread * (1 + 1e-9));
  EXPECT_GE(*large / *small, 0.1 * recipe_.spread);
}

TEST_P(EveryGenerator, LeavesNothingApartWhereNothingIsMissing) {
  // Spheres are bridged over any gap between neighbours, fibres fill the cube.
  recipe_.fraction = GetParam() == "spheres" ? 1 : 0;
  if (GetParam() == "spheres") recipe_.spread = 2;
  const auto graph = generator_.make(recipe_).graph;
  EXPECT_EQ(connected_components(graph.nodes(), graph.i, graph.j, graph.conductance).count, 1u);
}

TEST(PowerOfSquareRoots, IsThePower) {
  for (const double base : {1.0, 2.0, 10.0, 1e12})
    for (const double part : {0.0, 0.1, 0.5, 0.999, 1.0})  // 40 digits leave 1e-12 of the logarithm
      EXPECT_NEAR(std::log(power(base, part)), part * std::log(base), 1e-10) << base << " " << part;
}

TEST(CubeRoot, IsTheRoot) {
  for (const double x : {1.0, 8.0, 1e3, 1e12}) EXPECT_NEAR(cube_root(x) / std::cbrt(x), 1, 1e-14);
}

}  // namespace
}  // namespace superstep
