#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "dynamics/random_addition.hpp"
#include "integrators/press/step_control.hpp"
#include "press.hpp"

namespace superstep {
namespace {

using namespace test;

/// Three particles of different temperature that collide: motion, softening and heat all take part.
struct Trio {
  Trio() {
    model = quiet_model(1);
    model.gravity = 9.81;
    model.drag.coefficient = 0.1;
    model.contact.softening = {1500, 1e6};
    model.contact.friction = 0.1;
    model.contact.friction_speed = 0.5;
    model.thermal.conductivity = 1e5;
    // All in contact from the start: every force is smooth during the run.
    cloud.add({0, 0, 0}, {0.2, 0, 0}, 0.075, 300);
    cloud.add({0.13, 0.01, 0}, {-0.2, 0.1, 0}, 0.075, 900);
    cloud.add({0.06, 0.11, 0.01}, {0, -0.3, 0}, 0.08, 600);
  }
  Model model;
  Cloud cloud;

  [[nodiscard]] State finish(double step, double phi) const {
    Motion motion(model, cloud.particles, fixed_step(step, phi));
    motion.start(cloud.state);
    const Outcome outcome = motion.advance(0.02);
    EXPECT_TRUE(outcome.ok()) << outcome.reason;
    EXPECT_EQ(motion.rejected(), 0U) << "fixed steps";
    return motion.state();
  }
};

double distance(const State& a, const State& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += norm(a.position[i] - b.position[i]) + 1e-2 * norm(a.velocity[i] - b.velocity[i]) +
           1e-4 * std::abs(a.temperature[i] - b.temperature[i]);
  return sum;
}

TEST(PhiRule, IsOfOrderTwoAtOneHalfAndOneElsewhere) {
  const Trio trio;
  const State exact = trio.finish(0.02 / 16384, 0.5);
  for (const auto& [phi, order] : {std::pair{0.5, 2.0}, std::pair{1.0, 1.0}, std::pair{0.0, 1.0}}) {
    const double coarse = distance(trio.finish(0.02 / 128, phi), exact);
    const double fine = distance(trio.finish(0.02 / 256, phi), exact);
    ASSERT_GT(fine, 1e-9) << "far above the iteration's tolerance";
    EXPECT_NEAR(std::log2(coarse / fine), order, 0.1) << "phi = " << phi << ": next term of the expansion";
  }
}

TEST(PlainScheme, IsOfOrderOne) {
  const Trio trio;
  const State exact = trio.finish(0.02 / 16384, 0.5);
  const auto finish = [&](double step) {
    SteppingSettings settings = fixed_step(step);
    settings.scheme = SteppingSettings::Scheme::plain;
    Motion motion(trio.model, trio.cloud.particles, settings);
    motion.start(trio.cloud.state);
    EXPECT_TRUE(motion.advance(0.02).ok());
    return motion.state();
  };
  const double ratio = distance(finish(0.02 / 512), exact) / distance(finish(0.02 / 1024), exact);
  EXPECT_NEAR(std::log2(ratio), 1, 0.1);
}

TEST(FieldError, FollowsThePrintedFormula) {
  FieldError error{.tolerance = 1e-4};
  error.measure(1, 0.2, 1.0, 0);
  error.measure(2, 0.05, 1.0, 0);
  error.measure(3, 0.0125, 1.0, 0);
  EXPECT_DOUBLE_EQ(error.violation(), 125);
  // w_0 = 0.2, w_2 = 0.0125, K = 2, K_d = 10, p = 2
  EXPECT_DOUBLE_EQ(error.factor(3, 10, 2, 1), std::pow(1e-4 / 0.2, 0.05) / std::pow(0.0625, 0.25));
  EXPECT_EQ(error.factor(1, 10, 2, 7), 7) << "one iterate shows no rate";
  error.begin();
  error.measure(1, 0, 0, 0);
  EXPECT_EQ(error.violation(), 0) << "nothing moves";
}

TEST(StepBounds, Hold) {
  const StepBounds bounds;
  EXPECT_EQ(bounds.after_success(100), 2);
  EXPECT_EQ(bounds.after_success(0.5), 0.5);
  EXPECT_EQ(bounds.after_failure(5), 0.9);
  EXPECT_EQ(bounds.after_failure(1e-9), 0.1);
}

TEST(Adaptation, ShrinksInACollisionAndGrowsAfterIt) {
  Model model = quiet_model();
  model.contact.stiffness = 1e10;
  Cloud cloud;
  cloud.add({-0.2, 0, 0}, {2, 0, 0});
  cloud.add({0.2, 0, 0}, {-2, 0, 0});
  SteppingSettings settings;
  settings.control = SteppingSettings::Control::paper;
  Motion motion(model, cloud.particles, settings);
  motion.start(cloud.state);
  ASSERT_TRUE(motion.advance(0.2).ok());
  const auto& history = motion.history();
  const auto smallest = std::min_element(history.begin() + 1, history.end(),
                                         [](const auto& a, const auto& b) { return a.step < b.step; });
  EXPECT_GT(motion.rejected(), 0U);
  EXPECT_LT(smallest->step, 0.25 * settings.largest_step);
  EXPECT_EQ(smallest->contacts, 1) << "the smallest step is taken in the contact";
  EXPECT_TRUE(std::any_of(smallest, history.end(), [&](const auto& row) {
    return row.step == settings.largest_step;
  })) << "free flight again";
  EXPECT_LT(motion.state().velocity[0].x, 0);
}

TEST(Adaptation, SteadyControlMakesHardlyAStepAgain) {
  // A bed that is shaken together: contacts form and part all the time.
  Model model = quiet_model(0.3);
  model.gravity = 9.81;
  model.contact.stiffness = 1e8;
  model.contact.damping = 0.2;
  Cloud cloud;
  Random random(5);
  for (const Vec3& centre : random_addition(model.box, 30, 0.075, 5))
    cloud.add(centre, {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)});
  const auto rejected_part = [&](SteppingSettings::Control control) {
    SteppingSettings settings;
    settings.control = control;
    Motion motion(model, cloud.particles, settings);
    motion.start(cloud.state);
    EXPECT_TRUE(motion.advance(0.3).ok());
    return static_cast<double>(motion.rejected()) / static_cast<double>(motion.history().size());
  };
  // Contacts that close faster than the bound can see still cost an attempt now and then.
  EXPECT_LT(rejected_part(SteppingSettings::Control::steady),
            0.5 * rejected_part(SteppingSettings::Control::paper));
}

TEST(Motion, OrderOfParticlesDoesNotMatter) {
  Model model = quiet_model(0.4);
  model.gravity = 9.81;
  model.contact.friction = 0.1;
  model.contact.friction_speed = 0.1;
  model.contact.damping = 0.2;
  model.bond = {.stiffness = 1e6, .exponent = 2, .threshold = 0.03, .rule = BondRule::tension};
  model.thermal.conductivity = 1e4;
  Cloud cloud;
  Random random(31);
  for (const Vec3& centre : random_addition(model.box, 60, 0.075, 31))
    cloud.add(centre, {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)}, 0.075,
              random.uniform(300, 900));
  const std::size_t n = cloud.particles.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), 0);
  Random(3).shuffle(order);
  Cloud shuffled = cloud;
  for (std::size_t k = 0; k < n; ++k) {
    shuffled.particles.id[k] = cloud.particles.id[order[k]];
    shuffled.particles.radius[k] = cloud.particles.radius[order[k]];
    shuffled.particles.mass[k] = cloud.particles.mass[order[k]];
    shuffled.state.position[k] = cloud.state.position[order[k]];
    shuffled.state.velocity[k] = cloud.state.velocity[order[k]];
    shuffled.state.temperature[k] = cloud.state.temperature[order[k]];
  }
  const auto finish = [&](const Cloud& one) {
    Motion motion(model, one.particles, fixed_step(5e-4, 0.5, 1e-13));
    motion.start(one.state);
    const Outcome outcome = motion.advance(0.05);
    EXPECT_TRUE(outcome.ok()) << outcome.reason;
    return motion.state();
  };
  const State a = finish(cloud), b = finish(shuffled);
  ASSERT_GT(a.bonds.size(), 5U) << "they did meet";
  EXPECT_EQ(a.bonds.size(), b.bonds.size());
  for (std::size_t k = 0; k < n; ++k) {
    EXPECT_LT(norm(a.position[order[k]] - b.position[k]), 1e-10) << "rounding, amplified by some collisions";
    EXPECT_LT(std::abs(a.temperature[order[k]] - b.temperature[k]), 1e-7);
  }
}

TEST(Motion, PhasesAndOutputTimesEndExactlyAtSteps) {
  Model model = quiet_model(0.5);
  Phase one = model.schedule.phases().front(), two = one;
  one.end = 0.0123;
  two.begin = one.end;
  two.upper_wall = 0.4;
  two.end = 0.05;
  model.schedule = Schedule({one, two});
  Cloud cloud;
  cloud.add({0, 0, 0}, {1, 0, 0});
  Motion motion(model, cloud.particles, SteppingSettings{});
  motion.start(cloud.state);
  for (const double t : {0.01, 0.03, 0.05}) {
    ASSERT_TRUE(motion.advance(t).ok());
    EXPECT_EQ(motion.state().time, t);
  }
  EXPECT_TRUE(std::any_of(motion.history().begin(), motion.history().end(),
                          [](const auto& row) { return row.time == 0.0123 && row.phase == 0; }));
  for (const auto& row : motion.history()) EXPECT_TRUE(row.step == 0 || row.step > 1e-4) << "no slivers";
}

}  // namespace
}  // namespace superstep
