/// Packings that are read in parts and stand in layers: parts together are the whole, and spheres that touch
/// are never far apart.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/error.hpp"
#include "packing/parts/layers.hpp"
#include "packing/parts/table_part.hpp"
#include "packing/read.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

Packing random_packing(unsigned seed, std::size_t size, Vec3 side, double smallest, double largest) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  Packing packing;
  for (std::size_t k = 0; k < size; ++k) {
    packing.id.push_back(static_cast<std::int64_t>((k * 7919) % size) - 5);
    packing.centre.push_back({uniform(-1, side.x - 1), uniform(0, side.y), uniform(3, side.z + 3)});
    packing.radius.push_back(uniform(smallest, largest));
    packing.material.push_back(0);
  }
  return packing;
}

LayerPlace place_in(const PackingLayers& layers, const Packing& packing, std::size_t k) {
  return layers.place_of(packing.centre[k], packing.id[k]);
}

PackingLayers layers_of(const Packing& packing) {
  Bounds box{packing.centre[0], packing.centre[0]};
  for (const Vec3 c : packing.centre) {
    box.min = {std::min(box.min.x, c.x), std::min(box.min.y, c.y), std::min(box.min.z, c.z)};
    box.max = {std::max(box.max.x, c.x), std::max(box.max.y, c.y), std::max(box.max.z, c.z)};
  }
  return {box, *std::max_element(packing.radius.begin(), packing.radius.end()),
          static_cast<std::int64_t>(packing.size())};
}

TEST(PackingLayers, SpheresThatTouchStandInNeighbouringLayers) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const double thin = seed % 3 == 0 ? 1e-9 : 1.0;
    const Packing packing = random_packing(seed, 400, {seed % 4 == 1 ? 40.0 : 2.0, 3 * thin, 6.0}, 0.02, 0.3);
    const PackingLayers layers = layers_of(packing);
    ASSERT_GE(layers.count(), 1);
    for (std::size_t i = 0; i < packing.size(); ++i) {
      const LayerPlace a = place_in(layers, packing, i);
      EXPECT_TRUE(a.layer >= 0 && a.layer < layers.count());
      EXPECT_LE(layers.distance(a.layer, a.layer + 1, packing.centre[i]), 0.0);
      for (std::size_t j = 0; j < i; ++j) {
        const LayerPlace b = place_in(layers, packing, j);
        const double distance = norm(packing.centre[i] - packing.centre[j]);
        if (distance < packing.radius[i] + packing.radius[j]) {
          EXPECT_LE(std::abs(a.layer - b.layer), 1);
        }
        EXPECT_LE(layers.distance(b.layer, b.layer + 1, packing.centre[i]), distance);
      }
    }
  }
}

// Far fewer layers than lengths of a sphere: there are no more than spheres.
TEST(PackingLayers, AFewSpheresFarApartAreFewLayers) {
  Packing packing = random_packing(1, 3, {1, 1, 1}, 1e-9, 2e-9);
  packing.centre[1].x = 1e9;
  EXPECT_LE(layers_of(packing).count(), 3);
  packing = random_packing(1, 1, {1, 1, 1}, 1, 2);
  EXPECT_EQ(layers_of(packing).count(), 1);
}

TEST(PackingLayers, TheOrderDoesNotHangOnThatOfTheFile) {
  Packing one = random_packing(3, 300, {2, 2, 9}, 0.1, 0.3), other;
  for (std::size_t k = one.size(); k-- > 0;) {
    other.id.push_back(one.id[k]);
    other.centre.push_back(one.centre[k]);
    other.radius.push_back(one.radius[k]);
    other.material.push_back(0);
  }
  one.attributes.push_back({"id again", {one.id.begin(), one.id.end()}});
  stand_in_layers(one);
  stand_in_layers(other);
  EXPECT_EQ(one.id, other.id);
  EXPECT_EQ(one.radius, other.radius);
  EXPECT_EQ(*one.mean_diameter, *other.mean_diameter);
  EXPECT_TRUE(one.in_order);
  for (std::size_t k = 0; k < one.size(); ++k)
    EXPECT_EQ(static_cast<double>(one.id[k]), one.attributes.front().value[k]);
  EXPECT_FALSE(std::is_sorted(one.id.begin(), one.id.end()));
}

/// Rows with comments and blank lines between them; the last one may lack its end.
std::string table_text(std::size_t rows, const std::string& end, bool ids, bool last_end) {
  std::string text = "# length_unit = \"um\"" + end + (ids ? "id," : "") + "x,y,z,r,note" + end;
  for (std::size_t k = 0; k < rows; ++k) {
    if (k % 7 == 3) text += "# a comment, and a long one at that" + end;
    if (k % 11 == 5) text += end;
    if (ids) text += fmt::format("{},", 1000 - 3 * k);
    text += fmt::format("{},{},{},0.{},{}", 0.5 * static_cast<double>(k), k % 5, k * k, 1 + k % 9,
                        k % 2 ? "a" : "7");
    if (k + 1 < rows || last_end) text += end;
  }
  return text;
}

TEST(TableInParts, PartsTogetherAreTheWhole) {
  const test::TemporaryFolder folder;
  std::string why_not;
  for (const auto& [end, ids, last_end] :
       {std::tuple{"\n", true, true}, {"\r\n", true, false}, {"\n", false, false}, {"\n", false, true}}) {
    const std::string path = folder.write("rows.csv", table_text(60, end, ids, last_end));
    const Packing whole = read_packing(path);
    const auto table = TableInParts::open(path, {}, why_not);
    ASSERT_TRUE(table) << why_not;
    EXPECT_EQ(table->has_ids(), ids);
    EXPECT_EQ(table->length_unit(), 1e-6);
    for (const std::uint64_t parts : {1, 2, 3, 7, 50, 500, 5000}) {
      Packing together;
      for (std::uint64_t part = 0; part < parts; ++part) {
        const Packing one = table->read(table->bytes() * part / parts, table->bytes() * (part + 1) / parts);
        for (std::size_t k = 0; k < one.size(); ++k) {
          together.id.push_back(ids ? one.id[k] : static_cast<std::int64_t>(together.size()));
          together.centre.push_back(one.centre[k]);
          together.radius.push_back(one.radius[k]);
        }
      }
      EXPECT_EQ(together.id, whole.id) << parts;
      EXPECT_EQ(together.radius, whole.radius) << parts;
      for (std::size_t k = 0; k < std::min(whole.size(), together.size()); ++k)
        EXPECT_EQ(norm(together.centre[k] - whole.centre[k]), 0.0) << parts;
    }
  }
}

TEST(TableInParts, WhatIsKnownOnlyAtTheEndIsNotReadInParts) {
  const test::TemporaryFolder folder;
  for (const auto& [text, reason] : {std::pair{"0,0,0,1\n2,0,0,1\n", "names"},
                                     {"x,y,z,r,material\n0,0,0,1,a\n", "materials"},
                                     {"x,y,z,r,Time\n0,0,0,1,5\n", "time"},
                                     {"# cell = \"0 0 0 9 0 0 0 9 0 0 0 9\"\nx,y,z,r\n0,0,0,1\n", "box"},
                                     {"x,y,z,r\n", "rows"},
                                     {"\xef\xbb\xbfx,y,z,r\n0,0,0,1\n", "mark"},
                                     {"#format x_y_z_r\n0 0 0 1\n", "table"}}) {
    std::string why_not;
    EXPECT_FALSE(TableInParts::open(folder.write("rows.csv", text), {}, why_not)) << text;
    EXPECT_NE(why_not.find(reason), std::string::npos) << why_not;
  }
  std::string why_not;
  PackingOptions declared;
  declared.columns = {"x", "y", "z", "radius"};
  const auto table = TableInParts::open(folder.write("rows.csv", "0,0,0,1\n2,0,0,1\n"), declared, why_not);
  ASSERT_TRUE(table) << why_not;
  EXPECT_EQ(table->read(0, table->bytes()).size(), 2u);
}

TEST(TableInParts, APartThatIsWrongIsRefused) {
  const test::TemporaryFolder folder;
  std::string why_not;
  const auto table =
      TableInParts::open(folder.write("rows.csv", "x,y,z,r\n0,0,0,1\n2,0,0,1\n4,0,0,-1\n"), {}, why_not);
  ASSERT_TRUE(table);
  EXPECT_EQ(table->read(0, 5).size(), 1u);
  EXPECT_THROW((void)table->read(0, table->bytes()), InputError);
}

}  // namespace
}  // namespace superstep
