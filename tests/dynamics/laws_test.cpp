#include <gtest/gtest.h>

#include <limits>

#include "dynamics/contacts/bond_registry.hpp"
#include "dynamics/laws/bonds/rest_length_bond.hpp"
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

/// Whether a pair is bonded after a step that ends at this strain.
bool stays(const BondLaw& law, bool bonded, double strain, double largest_overlap) {
  const double margin = bond_kind(law.rule).margin(law, strain, {largest_overlap, 0}, bonded);
  return bonded ? margin >= 0 : margin <= 0;
}

TEST(BondLaw, PrintedRuleActsOnlyBeyondItsThreshold) {
  const BondLaw law{.stiffness = 1e6, .exponent = 2, .threshold = 0.1, .rule = BondRule::overlap};
  EXPECT_TRUE(stays(law, false, -0.11, 0.11));
  EXPECT_FALSE(stays(law, true, -0.09, 0.11)) << "forgets";
}

TEST(BondLaw, TensionRuleHoldsUntilItIsTorn) {
  const BondLaw law{
      .stiffness = 1e6, .exponent = 2, .threshold = 0.1, .rule = BondRule::tension, .rupture = 0.05};
  EXPECT_FALSE(stays(law, false, -0.09, 0.09)) << "never formed";
  EXPECT_TRUE(stays(law, true, -0.09, 0.11));
  EXPECT_TRUE(stays(law, true, 0.04, 0.11));
  EXPECT_FALSE(stays(law, true, 0.06, 0.11));
}

BondLaw neck_law() {
  return {.stiffness = 1e7,
          .threshold = 0.1,
          .rule = BondRule::rest_length,
          .rupture = 0.2,
          .unloading = 0.02,
          .growth = {.rate = 2, .activation = 1e5, .reference = 1200, .sintering_stress = 1e5}};
}

BondedPair neck_pair(double overlap) {
  return {.strain = -overlap,
          .temperature = 900,
          .pressure = 4e5,
          .mobility = 0.7,
          .contact_area = overlap > 0 ? 2e-3 * overlap : 0,
          .bond_area = 3e-3,
          .neck = 0.6,
          .radius_sum = 0.15,
          .reduced_mass = 2};
}

TEST(RestLengthBond, IsPushedAtItsLongestOverlapAndPulledBackToItFromAnywhereElse) {
  const BondLaw law = neck_law();
  const BondMemory memory{0.15, 0.6};
  const BondAction at_rest = RestLengthBond::act(law, neck_pair(0.15), memory);
  EXPECT_EQ(at_rest.pull, 0);
  EXPECT_EQ(at_rest.keep, 1);
  // By hand: x = 0.05 is beyond the unloading strain and below half the rupture strain.
  const BondAction apart = RestLengthBond::act(law, neck_pair(0.10), memory);
  EXPECT_DOUBLE_EQ(apart.keep, 0.4);
  EXPECT_DOUBLE_EQ(apart.pull, 0.6 * 1e7 * 3e-3 * (0.15 - 0.10));
  EXPECT_DOUBLE_EQ(apart.area, 2e-4 + 0.6 * (3e-3 - 2e-4));
  const BondAction torn = RestLengthBond::act(law, neck_pair(-0.05), memory);
  EXPECT_NEAR(torn.pull, 0, 1e-9) << "x = 0.2, the rupture strain: 1 - 1 rounded";
  EXPECT_DOUBLE_EQ(torn.keep, 1);
}

TEST(RestLengthBond, ForceAndItsSlopeAreContinuous) {
  // Differences over 1e-5 of strain: where slopes were to jump, neighbouring ones would differ by the jump.
  const BondLaw law = neck_law();
  const BondMemory memory{0.15, 0.6};
  const auto force = [&](double apart) {
    const BondedPair pair = neck_pair(0.15 - apart);
    const BondAction action = RestLengthBond::act(law, pair, memory);
    return action.pull +
           (1 - action.keep) * 1e3;  // 1e3 N of repulsion, frozen: the contact law is smooth itself
  };
  constexpr double step = 1e-5;
  double largest = 0, jump = 0;
  double before = (force(step) - force(0)) / step;
  for (double apart = step; apart < 0.22; apart += step) {
    const double slope = (force(apart + step) - force(apart)) / step;
    jump = std::max(jump, std::abs(slope - before));
    largest = std::max(largest, std::abs(slope));
    before = slope;
  }
  EXPECT_LT(jump, 6 * largest * step / law.unloading) << "curvature of a smooth step, 6 over its width";
}

TEST(RestLengthBond, GrowsWithTemperatureTimeAndPressure) {
  const NeckGrowth law = neck_law().growth;
  EXPECT_DOUBLE_EQ(arrhenius_root(law, 1200), 1);
  EXPECT_NEAR(std::pow(arrhenius_root(law, 900), 2), std::exp(-1e5 / 8.31446 * (1 / 900.0 - 1 / 1200.0)),
              1e-6)
      << "digits of R";
  EXPECT_DOUBLE_EQ(growth_rate(law, 0.5, 1e5), 2) << "the sintering stress doubles it";
  // Frenkel: (x/a)^2 = k t as long as it is small; with its end 1 - exp(-k t).
  double u = 0;
  constexpr int steps = 1000;
  for (int k = 0; k < steps; ++k) u = grown(u, 2, 2, 1e-3, 0.5);
  EXPECT_NEAR(neck_part(law, u), 1 - std::exp(-2.0), 2e-7) << "order 2 in steps of k h = 2e-3";
  // Coble: (x/a)^6 = k t: a hundred times the time doubles the radius, but for what the first size takes off.
  const NeckGrowth coble{.mechanism = NeckGrowth::Mechanism::coble};
  EXPECT_NEAR(neck_part(coble, 0.064) / neck_part(coble, 0.001), 4, 0.5) << "s goes with the cube root";
  EXPECT_EQ(neck_part(coble, 0), 0);
  EXPECT_DOUBLE_EQ(neck_part(coble, 1), 1);
  const BondLaw bond = neck_law();
  EXPECT_EQ(RestLengthBond::rate(bond, neck_pair(0.1), {0.1, 0}), 0) << "at the threshold, smoothly";
  EXPECT_GT(RestLengthBond::rate(bond, neck_pair(0.15), {0.15, 0}), 0);
  EXPECT_EQ(RestLengthBond::rate(bond, neck_pair(0.12), {0.15, 0}), 0) << "unloaded: no stress-free growth";
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
