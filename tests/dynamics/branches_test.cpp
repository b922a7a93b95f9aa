/// Branches of the potential form: conductivities that follow the field, and where their heat goes.

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "press.hpp"

namespace superstep {
namespace {

using namespace test;

/// One sphere, pressed into both electrified walls: two resistors in series, of the lengths d and areas A.
struct BetweenWalls {
  Model model = quiet_model();
  Cloud cloud;
  static constexpr double r = 0.1, d[] = {0.09, 0.08};

  BetweenWalls() {
    model.box = {{-1, -1, 0}, {1, 1, 0.17}};
    model.contact.stiffness = model.wall.stiffness = 0;
    model.electric.model = CurrentModel::potential;
    model.electric.hold_temperature = false;
    Phase phase = model.schedule.phases().front();
    phase.upper_wall_begin = phase.upper_wall = 0.17;
    phase.lower = 0;
    phase.upper = 1;
    model.schedule = Schedule({phase});
    cloud.add({0, 0, 0.09}, {}, r);
  }
  [[nodiscard]] double current(int which, double drop) const {
    const double area = std::numbers::pi * (r * r - d[which] * d[which]), field = drop / d[which];
    return model.electric.saturation.factor(300, field) * area * field;
  }
};

TEST(Eq50, PotentialsObeyKirchhoffWhereTheFieldLiesBelowTheReference) {
  BetweenWalls one;
  for (const double slope : {1.0, 10.0, 100.0})
    for (const double reference : {0.5, 4.1, 5.0, 5.5, 6.2, 7.0, 20.0}) {
      one.model.electric.saturation = {.field = 1, .field_slope = slope, .reference_field = reference};
      MovingNetwork network(one.model, one.cloud.particles);
      State state = one.cloud.state;
      network.resume(state, one.model.schedule.at(0));
      network.settle(state, one.model.schedule.at(0));
      const double v = state.electric[0], in = one.current(1, 1 - v), out = one.current(0, v);
      EXPECT_NEAR(in, out, 1e-7 * in) << "tolerance 1e-10 times the slope of the law; V = " << v << " at "
                                      << slope << " m/V and " << reference << " V/m";
      EXPECT_NEAR(network.current().heat()[0], out * v + in * (1 - v), 1e-7 * in);
    }
}

TEST(Eq50, PotentialsOfBedsObeyKirchhoff) {
  Model model = quiet_model(0.2);
  model.electric.model = CurrentModel::potential;
  model.electric.hold_temperature = false;
  Phase phase = model.schedule.phases().front();
  phase.lower = 0;
  phase.upper = 1;
  model.schedule = Schedule({phase});
  const Cloud cloud = random_cloud(30, 0.19, 5);
  for (const double slope : {3.0, 10.0, 30.0, 100.0})
    for (const double reference : {1.0, 2.5, 4.0, 6.0}) {
      model.electric.saturation = {.field = 20, .field_slope = slope, .reference_field = reference};
      MovingNetwork network(model, cloud.particles);
      State state = cloud.state;
      network.resume(state, model.schedule.at(0));
      network.settle(state, model.schedule.at(0));
      ASSERT_GT(network.current().connected(), 20U);
      const auto& v = state.electric;
      std::vector<double> into(v.size(), 0);
      double largest = 0;
      const auto flow = [&](double drop, double distance, double area) {
        const double field = drop / distance;
        const double current = model.electric.saturation.factor(300, std::abs(field)) * area * field;
        largest = std::max(largest, std::abs(current));
        return current;
      };
      for (const auto& contact : network.placement().contacts) {
        const auto i = static_cast<std::size_t>(contact.i), j = static_cast<std::size_t>(contact.j);
        const double current = flow(v[j] - v[i], contact.distance, contact.area);
        into[i] += current;
        into[j] -= current;
      }
      for (const auto& contact : network.walls()) {
        if (contact.wall != lower && contact.wall != upper) continue;
        const auto i = static_cast<std::size_t>(contact.particle);
        into[i] += flow((contact.wall == upper ? 1 : 0) - v[i], contact.distance, contact.area);
      }
      for (const double sum : into)
        EXPECT_NEAR(sum, 0, 1e-6 * largest) << "tolerance 1e-10 times slopes and contrasts of areas; "
                                            << slope << " m/V, " << reference << " V/m";
    }
}

/// No solution: a law without a fixed point of its turns, whatever part of them is taken.
TEST(Eq50, WhatDoesNotSettleIsAFailureThatKeepsTheState) {
  BetweenWalls one;
  one.model.electric.tolerance = 1e-30;  // nobody can meet that
  one.model.electric.saturation = {.field = 1, .field_slope = 10, .reference_field = 4.1};
  Phase quiet = one.model.schedule.phases().front(), live = quiet;
  quiet.end = live.begin = 0.01;
  quiet.lower.reset();
  quiet.upper.reset();
  one.model.schedule = Schedule({quiet, live});
  Motion motion(one.model, one.cloud.particles, SteppingSettings{});
  motion.start(one.cloud.state);
  const Outcome outcome = motion.advance(0.02);
  EXPECT_EQ(outcome.status, Status::failed);
  EXPECT_NE(outcome.reason.find("field_slope"), std::string::npos) << outcome.reason;
  EXPECT_EQ(motion.history().back().time, motion.state().time) << "the last step that was accepted";
  EXPECT_LT(motion.state().time, 0.01);
  EXPECT_EQ(motion.advance(0.02).status, Status::failed) << "and it stays a failure";
  one.model.schedule = Schedule({live});
  Motion at_once(one.model, one.cloud.particles, SteppingSettings{});
  EXPECT_THROW(at_once.start(one.cloud.state), NumericalError);
}

/// Two spheres of conductivities 1 and 9 between electrodes: their contact heats the poor one nine times as
/// much, as resistors in series do.
TEST(JouleHeat, OfAContactGoesWhereTheResistanceIs) {
  Model model = BetweenWalls().model;
  model.box.max.z = 0.3;
  Phase phase = model.schedule.phases().front();
  phase.upper_wall_begin = phase.upper_wall = 0.3;
  model.schedule = Schedule({phase});
  Cloud cloud;
  cloud.add({0, 0, 0.06}, {}, 0.1);
  cloud.add({0, 0, 0.24}, {}, 0.1);
  cloud.particles.electric_conductivity = {1, 9};
  MovingNetwork network(model, cloud.particles);
  network.resume(cloud.state, model.schedule.at(0));
  network.settle(cloud.state, model.schedule.at(0));
  const double pi = std::numbers::pi, area = pi * (0.01 - 0.09 * 0.09), foot = pi * (0.01 - 0.06 * 0.06);
  const double between = 5 * area / 0.18, low = foot / 0.06, high = 9 * foot / 0.06;
  const double current = 1 / (1 / low + 1 / between + 1 / high), square = current * current;
  const auto heat = network.current().heat();
  EXPECT_NEAR(heat[0], square * (1 / low + 0.9 / between), 1e-8 * square / between);
  EXPECT_NEAR(heat[1], square * (1 / high + 0.1 / between), 1e-8 * square / between);
}

TEST(WeightedLaplacian, ToleranceIsThatOfTheDifferences) {
  // A chain between 1e6 V and 1 V more: straight lines, and no more than 1e-9 of the volt beside them.
  constexpr std::size_t n = 21;
  std::vector<WeightedEdge> edges;
  for (std::int32_t i = 1; i < static_cast<std::int32_t>(n); ++i) edges.push_back({i - 1, i, 1.0 + i % 2});
  std::vector<char> fixed(n, 0);
  fixed.front() = fixed.back() = 1;
  for (const auto solver : {CurrentSolver::jacobi, CurrentSolver::conjugate}) {
    std::vector<double> x(n, 0.0), low(n, 0.0);
    x.front() = 1e6;
    x.back() = 1e6 + 1;
    low.back() = 1;
    WeightedLaplacian laplacian(solver, 1e-12);
    laplacian.solve(edges, fixed, x);
    laplacian.solve(edges, fixed, low);
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_NEAR(x[i] - 1e6, low[i], 1e-9) << "roundings of 1e6 V are 1e-10";
  }
}

}  // namespace
}  // namespace superstep
