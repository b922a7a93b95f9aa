/// Lattices: layers on their own are the layers of the whole, and know what they are a part of.

#include "packing/lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace superstep {
namespace {

const Lattice lattice{.cells = {4, 3, 5}, .spacing = 1e-3, .diameter = 1.1e-3};

TEST(Lattice, LayersAreThoseOfTheWhole) {
  const Packing whole = lattice_layers(lattice, 0, 5);
  ASSERT_EQ(whole.size(), 60u);
  EXPECT_FALSE(whole.part_of);
  std::size_t next = 0;
  for (std::int64_t layer = 0; layer < 5; layer += 2) {
    const Packing part = lattice_layers(lattice, layer, std::min<std::int64_t>(layer + 2, 5));
    for (std::size_t k = 0; k < part.size(); ++k, ++next) {
      EXPECT_EQ(part.id[k], whole.id[next]);
      EXPECT_EQ(part.radius[k], whole.radius[next]);
      EXPECT_EQ(norm(part.centre[k] - whole.centre[next]), 0.0);
    }
  }
  EXPECT_EQ(next, whole.size());
}

TEST(Lattice, ALayerKnowsTheBoxOfAll) {
  const Bounds whole = surface_bounds(lattice_layers(lattice, 0, 5));
  for (std::int64_t layer = 0; layer < 5; ++layer) {
    const Packing part = lattice_layers(lattice, layer, layer + 1);
    ASSERT_TRUE(part.part_of);
    EXPECT_EQ(part.part_of->particles, 60);
    EXPECT_EQ(norm(surface_bounds(part).min - whole.min), 0.0);
    EXPECT_EQ(norm(surface_bounds(part).max - whole.max), 0.0);
  }
}

TEST(Lattice, IdsCountAlongXFirst) {
  const Packing whole = lattice_layers(lattice, 0, 5);
  EXPECT_EQ(norm(whole.centre[4 + 1] - Vec3{1e-3, 1e-3, 0}), 0.0);
  EXPECT_EQ(norm(whole.centre[12] - Vec3{0, 0, 1e-3}), 0.0);
}

TEST(Lattice, SpheresThatHoldTheCentresOfOthersBreakARule) {
  Lattice one = lattice;
  EXPECT_EQ(broken_rule(one), "");
  one.diameter = 2 * one.spacing;
  EXPECT_NE(broken_rule(one).find("less than twice the spacing"), std::string::npos);
  one.cells = {1, 1, 1};
  EXPECT_EQ(broken_rule(one), "") << "there are no others";
}

}  // namespace
}  // namespace superstep
