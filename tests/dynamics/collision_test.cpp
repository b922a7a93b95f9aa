#include <gtest/gtest.h>

#include "press.hpp"

namespace superstep {
namespace {

using namespace test;

constexpr double r = 0.075, stiffness = 1e7;

Cloud head_on(double speed) {
  Cloud cloud;
  cloud.add({-r - 1e-12, 0, 0}, {speed, 0, 0});
  cloud.add({r + 1e-12, 0, 0}, {-speed, 0, 0});
  return cloud;
}

/// Overlap strain at which all kinetic energy of the relative motion is in the contact.
double deepest_strain(double mass, double speed) {
  double low = 0, high = 0.9;
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    (contact_energy(stiffness, r, middle) < mass * speed * speed ? low : high) = middle;
  }
  return low;
}

/// Duration of the contact: twice the integral of dx/v over the approach, x = x_max (1 - s^2) against the
/// singularity at the turning point, by the midpoint rule.
double contact_time(double mass, double speed) {
  const double deepest = deepest_strain(mass, speed);
  const double all = mass * speed * speed;
  constexpr int points = 200'000;
  double sum = 0;
  for (int k = 0; k < points; ++k) {
    const double s = (k + 0.5) / points, strain = deepest * (1 - s * s);
    const double left = all - contact_energy(stiffness, r, strain);
    const double closing = std::sqrt(4 * left / mass);  // reduced mass m/2
    sum += 2 * r * deepest * 2 * s / closing / points;
  }
  return 2 * sum;
}

/// At 40 m/s and the usual largest steps two particles are through each other between two step ends, unless a
/// step is short against their radii.
TEST(Collision, FastParticlesMeet) {
  for (const auto scheme : {SteppingSettings::Scheme::staggered, SteppingSettings::Scheme::plain}) {
    Model model = quiet_model(10);
    model.contact.stiffness = 1e12;  // stops them at a part of their radii
    Cloud cloud;
    cloud.add({-1, 0, 0}, {40, 0, 0});
    cloud.add({1, 0, 0}, {-40, 0, 0});
    SteppingSettings settings;
    settings.scheme = scheme;
    settings.first_step = settings.largest_step = 0.05;  // 2 m at their speed
    Motion motion(model, cloud.particles, settings);
    motion.start(cloud.state);
    double furthest = 0;
    Vec3 before = cloud.state.position[0];
    motion.after_step = [&] {
      furthest = std::max(furthest, norm(motion.state().position[0] - before));
      before = motion.state().position[0];
    };
    ASSERT_TRUE(motion.advance(0.05).ok());
    EXPECT_LT(motion.state().position[0].x, -r);
    EXPECT_LT(motion.state().velocity[0].x, 0) << "it turned back";
    EXPECT_LE(furthest, farthest_in_a_step * r * (1 + 1e-12));
  }
}

TEST(Collision, TurnsBackAtTheDepthThatTheEnergyIntegralGives) {
  const Model model = quiet_model();
  const Cloud cloud = head_on(1.0);
  Motion motion(model, cloud.particles, fixed_step(2e-5));
  motion.start(cloud.state);
  double deepest = 0;
  while (motion.state().time < 0.1) {
    ASSERT_TRUE(motion.advance(motion.state().time + 2e-5).ok());
    const Vec3 between = motion.state().position[1] - motion.state().position[0];
    deepest = std::max(deepest, -pair_strain(norm(between), 2 * r));
  }
  const double expected = deepest_strain(cloud.particles.mass[0], 1.0);
  // The deepest step end lies within half a step of the turning point: (pi h/2T)^2/2 = 8e-7 with T = 0.025 s;
  // the rule itself is off by some (pi h/T)^2/12 = 5e-7.
  EXPECT_NEAR(deepest, expected, 2e-6 * expected);
  EXPECT_NEAR(motion.state().velocity[0].x, -1.0, 1e-6) << "elastic: they part as they met";
  EXPECT_NEAR(motion.state().velocity[1].x, 1.0, 1e-6);
}

TEST(Collision, LastsAsLongAsTheQuadratureOfTheEnergyIntegralSays) {
  const Model model = quiet_model();
  const Cloud cloud = head_on(1.0);
  Motion motion(model, cloud.particles, fixed_step(1e-5));
  motion.start(cloud.state);
  const double lasts = contact_time(cloud.particles.mass[0], 1.0);
  ASSERT_TRUE(motion.advance(lasts + 0.01).ok());
  // After the contact they fly apart at the old speed: the distance tells when it ended.
  const double gap = norm(motion.state().position[1] - motion.state().position[0]) - 2 * r;
  EXPECT_NEAR(gap / 2.0, 0.01, 1e-4 * lasts) << "the quadrature's own error is 1e-5 of it";
}

TEST(Collision, WallReturnsAParticleAtItsSpeed) {
  Model model = quiet_model(0.2);
  Cloud cloud;
  cloud.add({0, 0, 0}, {1, 0, 0});
  Motion motion(model, cloud.particles, fixed_step(2e-5));
  motion.start(cloud.state);
  ASSERT_TRUE(motion.advance(0.2).ok());
  EXPECT_NEAR(motion.state().velocity[0].x, -1, 1e-6) << "order 2, step 1/1500 of the contact";
}

TEST(Collision, DampingTakesEnergyAwayAndNothingElseDoes) {
  for (const bool damped : {false, true}) {
    Model model = quiet_model();
    model.contact.damping = damped ? 0.2 : 0;
    const Cloud cloud = head_on(1.0);
    Motion motion(model, cloud.particles, fixed_step(2e-5));
    motion.start(cloud.state);
    const double before = kinetic_energy(cloud.particles, cloud.state);
    double last = before, rise = 0;
    while (motion.state().time < 0.1) {
      ASSERT_TRUE(motion.advance(motion.state().time + 2e-5).ok());
      const double strain =
          std::max(0.0, -pair_strain(norm(motion.state().position[1] - motion.state().position[0]), 2 * r));
      const double energy =
          kinetic_energy(cloud.particles, motion.state()) + contact_energy(stiffness, r, strain);
      rise = std::max(rise, energy - last);
      last = energy;
    }
    EXPECT_LE(rise, 2e-8 * before) << "order 2: the energy wavers by the error of a step";
    if (damped)
      EXPECT_LT(last, 0.9 * before);
    else
      EXPECT_NEAR(last, before, 1e-6 * before);
  }
}

TEST(Collision, ManyParticlesKeepTheirMomentum) {
  Model model = quiet_model(50);  // walls far away
  model.contact.damping = 0.1;
  model.contact.friction = 0.3;
  model.contact.friction_speed = 0.1;
  const Cloud cloud = random_cloud(60, 0.5, 11, 2.0);
  SteppingSettings settings;
  settings.largest_step = settings.first_step = 1e-3;
  Motion motion(model, cloud.particles, settings);
  motion.start(cloud.state);
  ASSERT_TRUE(motion.advance(0.05).ok());
  EXPECT_LT(kinetic_energy(cloud.particles, motion.state()), 1e9);
  const Vec3 lost = momentum(cloud.particles, motion.state()) - momentum(cloud.particles, cloud.state);
  double scale = 0;
  for (std::size_t i = 0; i < cloud.particles.size(); ++i)
    scale += cloud.particles.mass[i] * norm(motion.state().velocity[i]);
  EXPECT_LE(norm(lost), 1e-12 * scale) << "rounding, whatever the iteration's tolerance";
}

}  // namespace
}  // namespace superstep
