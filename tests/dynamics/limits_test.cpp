/// Steps of schemes that can be unstable keep below their limits, of motion and of heat.

#include <gtest/gtest.h>

#include <algorithm>

#include "press.hpp"

namespace superstep {
namespace {

using namespace test;

std::vector<HistoryRow> history_of(const Model& model, const Cloud& cloud, const SteppingSettings& settings,
                                   double t_end) {
  Motion motion(model, cloud.particles, settings);
  motion.start(cloud.state);
  const Outcome outcome = motion.advance(t_end);
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
  return motion.history();
}

SteppingSettings explicit_steps() {
  SteppingSettings settings;
  settings.scheme = SteppingSettings::Scheme::plain;
  return settings;
}

SteppingSettings leaning(double phi, SteppingSettings::Control control = SteppingSettings::Control::steady) {
  SteppingSettings settings;
  settings.phi = phi;
  settings.control = control;
  return settings;
}

/// At rest on a floor of 400 K whose heat arrives within a part of the largest step.
TEST(HeatLimit, TemperaturesStayBetweenThoseAroundThem) {
  Model model = quiet_model();
  model.contact.stiffness = model.wall.stiffness = 0;
  model.thermal.conductivity = 2e8;
  model.thermal.wall_temperature.fill(400);
  Cloud one, two;
  one.add({0, 0, -1 + 0.0675});
  two = one;
  two.add({0, 0, -1 + 0.2}, {}, 0.075, 350);  // touches the other one only
  using Control = SteppingSettings::Control;
  for (const auto& settings : {explicit_steps(), leaning(0), leaning(0, Control::paper), leaning(0.2)})
    for (const auto& cloud : {one, two}) {
      const auto history = history_of(model, cloud, settings, 0.05);
      for (const auto& row : history) {
        EXPECT_LE(row.max_temperature, 400 + 1e-9) << "at " << row.time;
        EXPECT_GE(row.mean_temperature, 300 - 1e-9) << "at " << row.time;
      }
      EXPECT_NEAR(history.back().mean_temperature, 400, 1e-6) << "a hundred time constants and more";
    }
}

TEST(HeatLimit, IsThatOfTheFastestParticle) {
  Model model = quiet_model();
  model.thermal.conductivity = 3;
  Cloud cloud;
  cloud.add({0, 0, -1 + 0.07});
  cloud.add({0, 0, -1 + 0.2});
  MovingNetwork network(model, cloud.particles);
  network.resume(cloud.state, model.schedule.at(0));
  const double r = 0.075, pi = std::numbers::pi;
  const double pair = 3 * pi * (r * r - 0.065 * 0.065) / 0.13, wall = 3 * pi * (r * r - 0.07 * 0.07) / 0.07;
  const double capacity = 100 * cloud.particles.mass[0];
  EXPECT_NEAR(network.heat_limit(), capacity / (pair + wall), 1e-12 * capacity / (pair + wall));
  model.thermal.walls_conduct = false;
  EXPECT_NEAR(network.heat_limit(), capacity / pair, 1e-12 * capacity / pair);
}

/// phi < 0.5 adds energy to what oscillates; damping has to take it.
TEST(MotionLimit, DampedParticlesComeToRest) {
  Model model = quiet_model();
  model.contact.damping = model.wall.damping = 0.3;
  Cloud cloud;
  cloud.add({0, 0, -1 + 0.06});  // pressed in by a fifth of its radius
  for (const double phi : {0.0, 0.25, 0.4}) {
    // It is thrown up, comes back to nothing without weight: what it has when it leaves must be below what
    // the contact held, the integral of K e^2 pi r^2 (2 e - e^2) over the way r e.
    const auto history = history_of(model, cloud, leaning(phi), 0.5);
    const double r = 0.075, e = 0.2, pi = std::numbers::pi;
    const double held = 1e7 * r * pi * r * r * (2 * std::pow(e, 4) / 4 - std::pow(e, 5) / 5);
    EXPECT_LT(history.back().kinetic_energy, held) << phi;
    EXPECT_GT(history.back().kinetic_energy, 0) << phi;
  }
  model.gravity = 9.81;
  for (const double phi : {0.0, 0.25, 0.4}) {
    const auto history = history_of(model, cloud, leaning(phi), 5);
    EXPECT_LT(history.back().kinetic_energy, 1e-6) << "it lies still in the end, phi = " << phi;
    std::int64_t rejections = 0;
    for (const auto& row : history) rejections += row.rejections;
    EXPECT_LT(rejections, static_cast<std::int64_t>(history.size() / 10)) << "contacts stiffen all the time";
  }
}

/// A hundred times stiffer than usual.
Model stiff_model() {
  Model model = quiet_model(0.75);
  model.contact.stiffness = model.wall.stiffness = 1e9;
  return model;
}

/// Two that fly at each other.
Cloud fast_pair() {
  Cloud cloud;
  cloud.add({-0.0825, 0, 0}, {10, 0, 0});
  cloud.add({0.0825, 0, 0}, {-10, 0, 0});
  return cloud;
}

/// Out of free flight, where nothing limits a step, into a stiff contact.
TEST(MotionLimit, HoldsAtTheEndOfAStepToo) {
  const Model model = stiff_model();
  const Cloud cloud = fast_pair();
  const double energy = kinetic_energy(cloud.particles, cloud.state);
  // Of the semi-implicit scheme kinetic energy swings by h omega/2 <= 1/2 in a contact; phi = 0 grows like
  // exp(pi h omega) in a contact, h omega <= 0.2.
  for (const auto& [settings, growth] :
       {std::pair{explicit_steps(), 1.5}, std::pair{leaning(0), std::exp(0.2 * std::numbers::pi)}}) {
    double largest = 0;
    const auto history = history_of(model, cloud, settings, 0.006);
    for (const auto& row : history) largest = std::max(largest, row.kinetic_energy);
    EXPECT_LT(largest, growth * energy) << "it was 31 times";
    EXPECT_GT(history.back().kinetic_energy, energy / 1.5) << "nothing is lost either";
  }
}

/// A step that a collision cut short grows again once it is over.
TEST(MotionLimit, StepsRecover) {
  const Model model = stiff_model();
  const Cloud cloud = fast_pair();
  SteppingSettings settings = explicit_steps();
  settings.largest_step = settings.first_step = 1e-3;
  Motion motion(model, cloud.particles, settings);
  motion.start(cloud.state);
  ASSERT_TRUE(motion.advance(0.03).ok());
  EXPECT_GT(motion.rejected(), 0U) << "the first contact came out of free flight";
  for (const auto& row : motion.history())
    if (row.time > 0.015 && row.time < 0.025) {
      EXPECT_EQ(row.step, 1e-3) << "in free flight again";
    }
}

}  // namespace
}  // namespace superstep
