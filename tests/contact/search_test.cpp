#include "contact/search.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

Packing packing_of(const std::vector<Vec3>& centres, const std::vector<double>& radii) {
  Packing packing;
  packing.centre = centres;
  packing.radius = radii;
  for (std::size_t k = 0; k < radii.size(); ++k) packing.id.push_back(static_cast<std::int64_t>(100 + k));
  packing.material.assign(radii.size(), 0);
  return packing;
}

/// Random spheres none of which swallows another: a candidate that would is drawn again. The cube is wide
/// enough (0.6 of it would be filled) for that to end soon.
Packing random_packing(std::size_t n, double ratio, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> radii;
  double volume = 0;
  for (std::size_t k = 0; k < n; ++k) {
    radii.push_back(std::pow(ratio, -random.uniform()));
    volume += 4.19 * radii.back() * radii.back() * radii.back();
  }
  const double side = std::cbrt(volume / 0.6);
  std::vector<Vec3> centres;
  while (centres.size() < n) {
    const Vec3 c{random.uniform(0, side), random.uniform(0, side), random.uniform(0, side)};
    bool swallows = false;
    for (std::size_t k = 0; k < centres.size() && !swallows; ++k)
      swallows = norm(centres[k] - c) <= std::abs(radii[k] - radii[centres.size()]) * 1.01;
    if (!swallows) centres.push_back(c);
  }
  return packing_of(centres, radii);
}

/// Every pair, one by one.
Contacts slow_contacts(const Packing& packing, double gap) {
  Contacts out;
  for (std::size_t i = 0; i < packing.size(); ++i)
    for (std::size_t j = i + 1; j < packing.size(); ++j) {
      const double overlap =
          packing.radius[i] + packing.radius[j] - norm(packing.centre[i] - packing.centre[j]);
      if (!(overlap > -gap)) continue;
      out.i.push_back(static_cast<std::int32_t>(i));
      out.j.push_back(static_cast<std::int32_t>(j));
      out.overlap.push_back(overlap);
    }
  return out;
}

class FindContacts : public testing::TestWithParam<double> {};

TEST_P(FindContacts, AgreesWithTheSlowSearchBitForBit) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto packing = random_packing(800, GetParam(), seed);
    for (const double gap : {0.0, 0.02}) {
      const auto fast = find_contacts(packing, gap), slow = slow_contacts(packing, gap);
      ASSERT_GT(slow.size(), 50u);
      EXPECT_EQ(fast.i, slow.i);
      EXPECT_EQ(fast.j, slow.j);
      EXPECT_EQ(fast.overlap, slow.overlap);
      EXPECT_TRUE(fast.neck_radius.empty());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Ratios, FindContacts, testing::Values(1.0, 20.0, 100.0));

TEST(FindContacts, TouchingIsNoContactOverlapIs) {
  EXPECT_EQ(find_contacts(packing_of({{0, 0, 0}, {2, 0, 0}}, {1, 1})).size(), 0u);
  const auto contacts = find_contacts(packing_of({{0, 0, 0}, {1.75, 0, 0}}, {1, 1}));
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_EQ(contacts.overlap[0], 0.25);
}

TEST(FindContacts, AGapIsBridgedUpToItsWidth) {
  const auto packing = packing_of({{0, 0, 0}, {2.25, 0, 0}, {0, 2.75, 0}}, {1, 1, 1});
  EXPECT_EQ(find_contacts(packing).size(), 0u);
  const auto bridged = find_contacts(packing, 0.5);
  ASSERT_EQ(bridged.size(), 1u);
  EXPECT_EQ(bridged.j[0], 1);
  EXPECT_EQ(bridged.overlap[0], -0.25);
}

TEST(FindContacts, ASphereAMillionRadiiAwayTouchesNothing) {
  auto packing = packing_of({{0, 0, 0}, {1.5, 0, 0}, {1e6, 1e6, -1e6}}, {1, 1, 1});
  EXPECT_EQ(find_contacts(packing).size(), 1u);
}

TEST(FindContacts, RefusesASwallowedSphereByIds) {
  const auto message = test::message_of<InputError>([] {
    (void)find_contacts(packing_of({{0, 0, 0}, {0.5, 0, 0}}, {1, 0.25}));
  });
  EXPECT_NE(message.find("particle 101 (radius 0.25 m) lies inside particle 100"), std::string::npos)
      << message;
  EXPECT_NE(message.find("remove the inner one"), std::string::npos) << message;
  // Equal spheres at one point swallow each other; internally tangent ones count as swallowed too.
  EXPECT_THROW((void)find_contacts(packing_of({{0, 0, 0}, {0, 0, 0}}, {1, 1})), InputError);
  EXPECT_THROW((void)find_contacts(packing_of({{0, 0, 0}, {0.75, 0, 0}}, {1, 0.25})), InputError);
}

}  // namespace
}  // namespace superstep
