#include "packing/packing.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/random.hpp"
#include "packing/read.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

Packing two_spheres() {
  Packing packing;
  packing.id = {4, 9};
  packing.centre = {{0, 0, 0}, {3, -1, 2}};
  packing.radius = {1, 0.5};
  packing.material = {0, 0};
  return packing;
}

TEST(Packing, BoundsEncloseSurfacesAndVolumesAdd) {
  const auto bounds = surface_bounds(two_spheres());
  EXPECT_EQ(bounds.min.x, -1.0);
  EXPECT_EQ(bounds.min.y, -1.5);
  EXPECT_EQ(bounds.max.x, 3.5);
  EXPECT_EQ(bounds.max.z, 2.5);
  EXPECT_DOUBLE_EQ(sphere_volume(two_spheres()), 4.0 / 3.0 * std::numbers::pi * 1.125);
}

TEST(PackingCsv, ReadsBackEveryBit) {
  Random random(3);
  Packing packing;
  for (int k = 0; k < 1000; ++k) {
    packing.id.push_back(1000 - k);
    packing.centre.push_back({random.uniform() * 1e-4, -random.uniform(), random.uniform() * 1e6});
    packing.radius.push_back(random.uniform() + 1e-9);
    packing.material.push_back(k == 0 ? 0 : static_cast<std::int32_t>(random.below(2)));
  }
  packing.material_names = {"NiAl, cast", "1/4\" ball; pure Al"};  // delimiters and a quote
  const test::TemporaryFolder folder;
  const auto read = read_packing(folder.write("p.csv", packing_csv(packing)));
  EXPECT_EQ(read.id, packing.id);
  EXPECT_EQ(read.radius, packing.radius);
  EXPECT_EQ(read.material_names, packing.material_names);
  EXPECT_EQ(read.material, packing.material);
  for (std::size_t k = 0; k < packing.size(); ++k) {
    EXPECT_EQ(read.centre[k].x, packing.centre[k].x);
    EXPECT_EQ(read.centre[k].y, packing.centre[k].y);
    EXPECT_EQ(read.centre[k].z, packing.centre[k].z);
  }
}

TEST(PackingCsv, LeavesTheMaterialOutWhenThereIsNone) {
  EXPECT_EQ(packing_csv(two_spheres()), "# length_unit = \"m\"\nid,x,y,z,radius\n4,0,0,0,1\n9,3,-1,2,0.5\n");
}

}  // namespace
}  // namespace superstep
