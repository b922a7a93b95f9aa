#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "dynamics/contacts/contact_points.hpp"
#include "dynamics/random_addition.hpp"
#include "press.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

using namespace test;
using Pairs = std::set<std::pair<std::int32_t, std::int32_t>>;

Pairs every_pair_in_contact(const Cloud& cloud) {
  Pairs pairs;
  const auto n = static_cast<std::int32_t>(cloud.particles.size());
  for (std::int32_t i = 0; i < n; ++i)
    for (std::int32_t j = i + 1; j < n; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      if (norm(cloud.state.position[a] - cloud.state.position[b]) <
          cloud.particles.radius[a] + cloud.particles.radius[b])
        pairs.emplace(i, j);
    }
  return pairs;
}

Pairs found(const ContactPoints& contacts) {
  Pairs pairs;
  for (const auto& point : contacts.points()) pairs.emplace(point.i, point.j);
  return pairs;
}

TEST(Neighbours, NothingIsMissedUnderMotion) {
  Cloud cloud = random_cloud(300, 0.6, 41, 1.0);
  ContactPoints contacts(BondLaw{}, 0.03, cloud.particles);
  for (int step = 0; step < 200; ++step) {
    for (std::size_t i = 0; i < cloud.particles.size(); ++i)
      cloud.state.position[i] = cloud.state.position[i] + 2e-3 * cloud.state.velocity[i];
    contacts.place(cloud.state.position);
    ASSERT_EQ(found(contacts), every_pair_in_contact(cloud)) << "step " << step;
  }
  EXPECT_GT(contacts.list().builds(), 5U) << "the list was made anew";
  EXPECT_LT(contacts.list().builds(), 100U) << "but not at every step";
}

TEST(Neighbours, SuddenJumpIsNoticed) {
  Cloud cloud = random_cloud(100, 0.6, 42);
  ContactPoints contacts(BondLaw{}, 0.03, cloud.particles);
  contacts.place(cloud.state.position);
  cloud.state.position[7] = cloud.state.position[50] + Vec3{0.01, 0, 0};
  contacts.place(cloud.state.position);
  EXPECT_EQ(found(contacts), every_pair_in_contact(cloud));
}

TEST(Neighbours, ListedPairsPerParticleDoNotGrowWithTheirNumber) {
  // The same volume fraction at 1e3 and 3e4 particles: work per particle is the number of listed pairs.
  const auto pairs_per_particle = [](std::size_t count) {
    const double side = std::cbrt(static_cast<double>(count) * 4 / 3 * std::numbers::pi * 1e-3 / 0.25);
    const auto centres = random_addition({{0, 0, 0}, {side, side, side}}, count, 0.1, 1);
    NeighbourList list(0.03);
    list.update(centres, std::vector<double>(count, 0.1));
    return static_cast<double>(list.pairs().size()) / static_cast<double>(count);
  };
  const double few = pairs_per_particle(1000), many = pairs_per_particle(30'000);
  EXPECT_GT(few, 0.1);
  EXPECT_NEAR(many / few, 1, 0.25) << "fewer particles lie at walls of the larger box";
}

TEST(Neighbours, BondsSurviveNewLists) {
  BondLaw law{.stiffness = 1e6, .exponent = 2, .threshold = 0.05, .rule = BondRule::tension, .rupture = 0.2};
  Cloud cloud = random_cloud(150, 0.5, 43, 1.0);
  ContactPoints contacts(law, 0.02, cloud.particles);
  contacts.place(cloud.state.position);
  contacts.update_bonds();
  // The rule written out for every pair.
  std::set<std::pair<std::size_t, std::size_t>> bonded;
  const auto follow = [&] {
    for (std::size_t i = 0; i < cloud.particles.size(); ++i)
      for (std::size_t j = i + 1; j < cloud.particles.size(); ++j) {
        const double strain = pair_strain(norm(cloud.state.position[i] - cloud.state.position[j]),
                                          cloud.particles.radius[i] + cloud.particles.radius[j]);
        if (strain <= -law.threshold) bonded.emplace(i, j);
        if (strain > law.rupture) bonded.erase({i, j});
      }
  };
  follow();
  for (int step = 0; step < 60; ++step) {
    for (std::size_t i = 0; i < cloud.particles.size(); ++i)
      cloud.state.position[i] = cloud.state.position[i] + 1e-3 * cloud.state.velocity[i];
    contacts.place(cloud.state.position);
    contacts.update_bonds();
    follow();
    std::set<std::pair<std::size_t, std::size_t>> kept;
    for (const auto& bond : contacts.bonds())
      kept.emplace(static_cast<std::size_t>(bond.i), static_cast<std::size_t>(bond.j));
    ASSERT_EQ(kept, bonded) << "step " << step;
  }
  EXPECT_GT(contacts.list().builds(), 2U);
}

TEST(RandomAddition, PlacesWithoutOverlapInsideTheBox) {
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  const auto centres = random_addition(box, 1000, 0.075, 1);
  ASSERT_EQ(centres.size(), 1000U);
  for (std::size_t i = 0; i < centres.size(); ++i) {
    for (int w = 0; w < wall_count; ++w)
      EXPECT_GE(wall_distance(box, 1, static_cast<Wall>(w), centres[i]), 0.075);
    for (std::size_t j = i + 1; j < centres.size(); ++j) ASSERT_GE(norm(centres[i] - centres[j]), 0.15);
  }
  const auto again = random_addition(box, 1000, 0.075, 1), other = random_addition(box, 1000, 0.075, 2);
  EXPECT_EQ(again[999].x, centres[999].x);
  EXPECT_NE(other[999].x, centres[999].x);
}

/// In a nearly empty box there was a bin for each place that a sphere could have: 400 MB for these.
TEST(RandomAddition, AFewSmallSpheresInALargeBoxTakeLittleMemory) {
  const auto peak = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;  // kB
  };
  const auto before = peak();
  EXPECT_EQ(random_addition({{0, 0, 0}, {0.6, 0.6, 0.6}}, 50, 5e-4, 1).size(), 50U);
  EXPECT_LT(peak() - before, 50'000);
}

TEST(RandomAddition, SaysHowFarItIsAndRefusesTheImpossibleAtOnce) {
  std::vector<double> parts;
  const std::vector<double> radii(700, 0.05 * 1.26);
  const auto watch = [&](double part) { parts.push_back(part); };
  EXPECT_THROW((void)random_addition({{0, 0, 0}, {1, 1, 1}}, radii, 1, watch), NumericalError);
  ASSERT_GT(parts.size(), 5U) << "a million attempts for the last one";
  EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
  EXPECT_GT(parts.front(), 0);
  EXPECT_LT(parts.back(), 1);
  parts.clear();
  (void)random_addition({{0, 0, 0}, {1, 1, 1}}, std::vector<double>(100, 0.05), 1, watch);
  EXPECT_TRUE(parts.empty()) << "that takes a moment";
  const std::string message = message_of<NumericalError>([&] {
    (void)random_addition({{0, 0, 0}, {0.6, 0.6, 0.6}}, std::vector<double>(40'000, 0.01), 1, watch);
  });
  EXPECT_NE(message.find("nor would any arrangement"), std::string::npos) << message;
  EXPECT_TRUE(parts.empty());
}

TEST(RandomAddition, FailureIsAClearError) {
  const std::string message = message_of<NumericalError>([] {
    (void)random_addition({{0, 0, 0}, {1, 1, 1}}, 700, 0.05 * 1.26, 1);
  });
  EXPECT_NE(message.find("of 700 spheres"), std::string::npos) << message;
  EXPECT_NE(message.find("0.38"), std::string::npos) << message;
  EXPECT_THROW((void)random_addition({{0, 0, 0}, {1, 1, 0.1}}, 1, 0.06, 1), NumericalError);
}

}  // namespace
}  // namespace superstep
