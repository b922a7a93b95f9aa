#include <gtest/gtest.h>

#include <limits>

#include "dynamics/laws/damping.hpp"
#include "dynamics/laws/friction.hpp"
#include "dynamics/volume_fraction.hpp"
#include "press.hpp"

namespace superstep {
namespace {

using namespace test;

TEST(ContactLaw, AreaIsThatOfTheCircleInWhichTheSpheresIntersect) {
  // The circle lies in both spheres: points at height a above the axis have distance r_i and r_j from the
  // centres.
  for (const auto& [r_i, r_j, distance] : {std::array{0.1, 0.1, 0.15}, std::array{0.05, 0.1, 0.12}}) {
    const double a2 = pair_area(distance, r_i, r_j) / std::numbers::pi;
    EXPECT_NEAR(std::sqrt(r_i * r_i - a2) + std::sqrt(r_j * r_j - a2), distance, 1e-15) << "rounding";
  }
  EXPECT_NEAR(pair_area(0.2, 0.1, 0.1), 0.0, 1e-18);
  const double whole = std::numbers::pi * 0.05 * 0.05;  // of the smaller one
  EXPECT_DOUBLE_EQ(pair_area(0.06, 0.05, 0.1), whole) << "its centre has passed the plane";
  EXPECT_DOUBLE_EQ(pair_area(0.06, 0.1, 0.05), whole);
  EXPECT_NEAR(pair_area(std::sqrt(0.1 * 0.1 - 0.05 * 0.05), 0.1, 0.05), whole, 1e-12 * whole)
      << "no jump there";
}

TEST(ContactLaw, SoftensDownToItsFloor) {
  const Softening softening{500, 1e6};
  EXPECT_DOUBLE_EQ(softened(1e7, softening, 300), 4e6);
  EXPECT_DOUBLE_EQ(softened(1e7, softening, 450), 1e6);
  EXPECT_DOUBLE_EQ(softened(1e7, softening, 1000), 1e6);
  EXPECT_DOUBLE_EQ(softened(1e7, Softening{}, 1000), 1e7) << "no softening temperature, no softening";
}

TEST(ContactLaw, PowersAgreeWithPow) {
  for (const double p : {1.0, 1.5, 2.0, 3.0}) EXPECT_DOUBLE_EQ(strain_power(0.3, p), std::pow(0.3, p));
}

TEST(Friction, IsFullWhenSlidingAndNoneAtRest) {
  EXPECT_NEAR(friction_direction(0.1, {100, 0, 0}, 0.01).x, 0.1, 1e-9) << "(v_s/v)^2/2 = 5e-9 of mu_d below";
  EXPECT_EQ(norm(friction_direction(0.1, {}, 0.01)), 0);
}

TEST(Damping, NeverPulls) {
  EXPECT_DOUBLE_EQ(damped_push(10, 2, -3), 16);
  EXPECT_DOUBLE_EQ(damped_push(10, 2, 3), 4);
  EXPECT_DOUBLE_EQ(damped_push(10, 2, 30), 0);
}

TEST(BondLaw, PrintedRuleActsOnlyBeyondItsThreshold) {
  const BondLaw law{.stiffness = 1e6, .exponent = 2, .threshold = 0.1, .rule = BondRule::overlap};
  EXPECT_EQ(bond_after_step(law, 0, -0.11, 2e-3), 2e-3);
  EXPECT_EQ(bond_after_step(law, 2e-3, -0.09, 1e-3), 0) << "forgets";
}

TEST(BondLaw, TensionRuleHoldsUntilItIsTorn) {
  const BondLaw law{
      .stiffness = 1e6, .exponent = 2, .threshold = 0.1, .rule = BondRule::tension, .rupture = 0.05};
  EXPECT_EQ(bond_after_step(law, 0, -0.09, 1e-3), 0) << "never formed";
  EXPECT_EQ(bond_after_step(law, 2e-3, -0.09, 1e-3), 2e-3);
  EXPECT_EQ(bond_after_step(law, 2e-3, 0.04, 0), 2e-3);
  EXPECT_EQ(bond_after_step(law, 2e-3, 0.06, 0), 0);
}

TEST(VolumeFraction, CapsAddUpToTheSphere) {
  const double r = 0.3, whole = 4.0 / 3.0 * std::numbers::pi * r * r * r;
  EXPECT_DOUBLE_EQ(volume_below(r, 2 * r), whole);
  EXPECT_EQ(volume_below(r, -r), 0);
  EXPECT_NEAR(volume_below(r, 0.1) + volume_below(r, -0.1), whole, 1e-15) << "rounding";
}

TEST(Schedule, WallPassesThroughItsStations) {
  Phase down, rest;
  down.end = 2;
  down.upper_wall_begin = 1;
  down.upper_wall = -0.5;
  rest.begin = 2;
  rest.end = 3;
  rest.upper_wall_begin = rest.upper_wall = -0.5;
  const Schedule schedule({down, rest});
  EXPECT_DOUBLE_EQ(schedule.at(1).wall_height(1), 0.25);
  EXPECT_EQ(schedule.at(2).wall_height(2), -0.5);
  EXPECT_EQ(schedule.at(2).wall_velocity(), 0);
  EXPECT_EQ(schedule.at(99).upper_wall, -0.5) << "the last phase goes on";
  EXPECT_EQ(schedule.lowest_wall(), -0.5);
}

}  // namespace
}  // namespace superstep
