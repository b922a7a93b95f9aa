/// The shipped sample of Rojek & Nisar (2026), section 9.1: what its case file relies on.

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "contact/neck.hpp"
#include "contact/search.hpp"
#include "packing/read.hpp"

namespace superstep {
namespace {

Packing sample() {
  return read_packing(SUPERSTEP_SOURCE_DIR "/cases/packings/nial_cylinder.csv");
}

std::size_t components(const Packing& packing, const Contacts& contacts) {
  std::vector<std::size_t> parent(packing.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  };
  std::size_t count = packing.size();
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto a = root(static_cast<std::size_t>(contacts.i[k])),
               b = root(static_cast<std::size_t>(contacts.j[k]));
    if (a != b) --count;
    parent[a] = b;
  }
  return count;
}

TEST(NialCylinder, HasThePublishedSizesAndDensity) {
  const auto packing = sample();
  EXPECT_EQ(packing.size(), 17515u);
  const auto [low, high] = std::minmax_element(packing.radius.begin(), packing.radius.end());
  EXPECT_EQ(*low, 0.75e-6);
  EXPECT_EQ(*high, 10e-6);
  const double container = std::numbers::pi / 4 * 123.6e-6 * 123.6e-6 * 166e-6;
  EXPECT_NEAR(sphere_volume(packing) / container, 0.784, 1e-9);
  const auto bounds = surface_bounds(packing);
  EXPECT_GE(bounds.min.z, -1e-15);
  EXPECT_LE(bounds.max.z, 166e-6 + 1e-15);
}

TEST(NialCylinder, IsOnePieceWithoutBarelyTouchingSpheres) {
  const auto packing = sample();
  auto contacts = find_contacts(packing);
  EXPECT_EQ(components(packing, contacts), 1u);
  std::vector<double> deepest(packing.size(),
                              0.0);  // overlap over radius: a mere touch would slow a sphere down
  for (std::size_t k = 0; k < contacts.size(); ++k)
    for (const auto end : {contacts.i[k], contacts.j[k]}) {
      const auto i = static_cast<std::size_t>(end);
      deepest[i] = std::max(deepest[i], contacts.overlap[k] / packing.radius[i]);
    }
  EXPECT_GT(*std::min_element(deepest.begin(), deepest.end()), 1e-3);
  const auto report = apply_neck_law(packing, *find_neck_law("volume-preserving"), {}, contacts);
  EXPECT_LT(report.saturated, contacts.size() / 100);
}

}  // namespace
}  // namespace superstep
