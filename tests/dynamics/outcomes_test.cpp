#include <gtest/gtest.h>

#include <limits>

#include "core/error.hpp"
#include "press.hpp"

namespace superstep {
namespace {

using namespace test;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Outcomes, EscapingParticleIsNamedWithItsWall) {
  Model model = quiet_model(0.2);
  model.wall.stiffness = 10;  // far too soft to stop it
  Cloud cloud;
  cloud.add({0, 0, 0});
  cloud.add({0, 0.1, -0.05}, {0, 3, 0}, 0.02);
  Motion motion(model, cloud.particles, SteppingSettings{});
  motion.start(cloud.state);
  const Outcome outcome = motion.advance(0.2);
  EXPECT_EQ(outcome.status, Status::failed);
  EXPECT_TRUE(contains(outcome.reason, "particle 1 ")) << outcome.reason;
  EXPECT_TRUE(contains(outcome.reason, "+y wall")) << outcome.reason;
  EXPECT_GT(motion.history().size(), 3U) << "what came before is kept";
  EXPECT_EQ(motion.advance(0.3).status, Status::failed) << "and it stays a failure";
}

TEST(Outcomes, StepCollapseNamesTheParticleAndKeepsTheState) {
  const Model model = quiet_model();
  Cloud cloud;
  cloud.add({-0.5, 0, 0});
  cloud.add({-0.1, 0, 0}, {1, 0, 0});
  cloud.add({0.1, 0, 0}, {-1, 0, 0});
  SteppingSettings settings;
  settings.tolerance_position = 1e-300;  // nobody can meet that in contact, in two iterations
  settings.iterations = 2;
  settings.smallest_step = 1e-4;
  Motion motion(model, cloud.particles, settings);
  motion.start(cloud.state);
  const Outcome outcome = motion.advance(0.1);
  EXPECT_EQ(outcome.status, Status::failed);
  EXPECT_TRUE(contains(outcome.reason, "smallest_step")) << outcome.reason;
  EXPECT_TRUE(contains(outcome.reason, "particle 1 ") || contains(outcome.reason, "particle 2 "))
      << outcome.reason;
  EXPECT_EQ(motion.state().time, motion.history().back().time);
  EXPECT_GT(motion.state().time, 0.02) << "free flight was no trouble";
}

TEST(Outcomes, ALimitBelowTheSmallestStepIsAFailureAtOnce) {
  for (const auto scheme : {SteppingSettings::Scheme::staggered, SteppingSettings::Scheme::plain}) {
    SteppingSettings settings;
    settings.scheme = scheme;
    Cloud cloud;
    cloud.add({-0.07, 0, 0});
    cloud.add({0.07, 0, 0}, {0, 1e9, 0});  // 0.03 m in a step: 3e-11 s
    const Model model = quiet_model();
    Motion fast(model, cloud.particles, settings);
    fast.start(cloud.state);
    const Outcome of_speed = fast.advance(0.1);
    EXPECT_EQ(of_speed.status, Status::failed);
    EXPECT_TRUE(contains(of_speed.reason, "particle 1 moves at 1e+09 m/s")) << of_speed.reason;
    EXPECT_EQ(fast.history().size(), 1U);
    EXPECT_TRUE(fast.advance(1e-11).ok()) << "what is left is short enough";

    cloud.state.velocity[1] = {};
    Model stiff = quiet_model();
    stiff.contact.stiffness = 1e22;  // steps of some 1e-10 s
    Motion hard(stiff, cloud.particles, settings);
    hard.start(cloud.state);
    const Outcome of_stiffness = hard.advance(0.1);
    EXPECT_EQ(of_stiffness.status, Status::failed);
    EXPECT_TRUE(contains(of_stiffness.reason, "drag are that stiff")) << of_stiffness.reason;
    settings.smallest_step = 1e-14;
    Motion allowed(stiff, cloud.particles, settings);
    allowed.start(cloud.state);
    EXPECT_TRUE(allowed.advance(1e-8).ok());
  }
}

TEST(Outcomes, CoincidentCentresAreOneClearFailure) {
  for (const auto scheme : {SteppingSettings::Scheme::staggered, SteppingSettings::Scheme::plain}) {
    const Model model = quiet_model();
    Cloud cloud;
    cloud.add({0.5, 0, 0});
    cloud.add({0, 0, 0});
    cloud.add({0, 0, 0});
    SteppingSettings settings;
    settings.scheme = scheme;
    Motion motion(model, cloud.particles, settings);
    motion.start(cloud.state);
    const Outcome outcome = motion.advance(0.1);
    EXPECT_EQ(outcome.status, Status::failed);
    EXPECT_TRUE(contains(outcome.reason, "particle 1 ")) << outcome.reason;
    EXPECT_TRUE(contains(outcome.reason, "not finite")) << outcome.reason;
    EXPECT_EQ(motion.state().time, 0);
  }
}

TEST(Outcomes, NanVelocityIsOneClearFailure) {
  const Model model = quiet_model();
  Cloud cloud;
  cloud.add({0.5, 0, 0});
  cloud.add({0, 0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0, 0});
  Motion motion(model, cloud.particles, SteppingSettings{});
  motion.start(cloud.state);
  const Outcome outcome = motion.advance(0.1);
  EXPECT_EQ(outcome.status, Status::failed);
  EXPECT_TRUE(contains(outcome.reason, "particle 1 ")) << outcome.reason;
}

TEST(Outcomes, ZeroParticlesAreAnInputError) {
  const Model model = quiet_model();
  EXPECT_THROW(Motion(model, Particles{}, SteppingSettings{}), InputError);
}

TEST(Outcomes, ImpossibleSettingsAreInputErrors) {
  const Model model = quiet_model();
  Cloud cloud;
  cloud.add({0, 0, 0});
  for (const auto& spoil : std::vector<void (*)(SteppingSettings&)>{
           [](SteppingSettings& s) { s.phi = 1.5; }, [](SteppingSettings& s) { s.iterations = 1; },
           [](SteppingSettings& s) { s.largest_step = 1e-12; },
           [](SteppingSettings& s) { s.bounds.growth = 1; }}) {
    SteppingSettings settings;
    spoil(settings);
    EXPECT_THROW(Motion(model, cloud.particles, settings), InputError);
  }
  SteppingSettings settings;
  settings.thermal_integrator = "rkq";
  EXPECT_THROW(Motion(model, cloud.particles, settings), UsageError);
}

TEST(Outcomes, NoPathMeansNoCurrent) {
  Model model = quiet_model();
  model.electric.model = CurrentModel::averaging;
  Phase phase = model.schedule.phases().front();
  phase.lower = phase.upper = 1e5;
  model.schedule = Schedule({phase});
  Cloud cloud;
  cloud.add({0, 0, 0});
  Motion motion(model, cloud.particles, SteppingSettings{});
  motion.start(cloud.state);
  ASSERT_TRUE(motion.advance(0.05).ok());
  EXPECT_EQ(motion.connected_in_step(), 0U);
  EXPECT_EQ(motion.state().temperature[0], 300);
}

TEST(Outcomes, FailingThermalIntegratorIsReportedByName) {
  Model model = quiet_model(0.2);
  model.thermal.conductivity = 1e9;
  const Cloud cloud = random_cloud(40, 0.18, 3, 0.1);
  SteppingSettings settings;
  settings.thermal_integrator = "forward-euler:step=1e-3";
  Motion motion(model, cloud.particles, settings);
  motion.start(cloud.state);
  const Outcome outcome = motion.advance(1);
  EXPECT_FALSE(outcome.ok());
  EXPECT_TRUE(contains(outcome.reason, "forward-euler:step=1e-3")) << outcome.reason;
}

TEST(Outcomes, StopFlagEndsAtAStep) {
  const Model model = quiet_model();
  Cloud cloud;
  cloud.add({0, 0, 0}, {1, 0, 0});
  const std::atomic<bool> stop{true};
  Motion motion(model, cloud.particles, SteppingSettings{});
  motion.stop = &stop;
  motion.start(cloud.state);
  EXPECT_EQ(motion.advance(1).status, Status::interrupted);
  EXPECT_EQ(motion.history().size(), 2U);
}

/// Whoever stops at the very instant that was asked for has got what he asked for.
TEST(Outcomes, StopFlagLeavesATimeThatWasReachedReached) {
  const Model model = quiet_model();
  Cloud cloud;
  cloud.add({0, 0, 0}, {1, 0, 0});
  std::atomic<bool> stop{false};
  Motion motion(model, cloud.particles, SteppingSettings{});
  motion.stop = &stop;
  motion.after_step = [&] { stop = motion.state().time >= 0.02; };
  motion.start(cloud.state);
  const Outcome outcome = motion.advance(0.02);
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_TRUE(stop);
  EXPECT_EQ(motion.advance(0.04).status, Status::interrupted);
}

/// A step of the motion may be a long way for what takes its temperatures.
TEST(Outcomes, StopFlagIsObeyedInsideAThermalIntegrator) {
  Model model = quiet_model();
  model.contact.stiffness = model.wall.stiffness = 0;
  model.thermal.conductivity = 2e8;  // its heat is gone in 0.03 ms, a step is 5 ms
  model.thermal.wall_temperature.fill(400);
  Cloud cloud;
  cloud.add({0, 0, -1 + 0.0675});
  for (const auto scheme : {SteppingSettings::Scheme::staggered, SteppingSettings::Scheme::plain}) {
    SteppingSettings settings;
    settings.scheme = scheme;
    settings.thermal_integrator = "forward-euler:step=1e-7";
    std::atomic<bool> stop{true};
    Motion motion(model, cloud.particles, settings);
    motion.stop = &stop;
    motion.start(cloud.state);
    const Outcome outcome = motion.advance(0.005);
    EXPECT_EQ(outcome.status, Status::interrupted) << outcome.reason;
    EXPECT_EQ(outcome.reason, "stopped at t = 0 s");
    EXPECT_EQ(motion.state().time, 0) << "the step was not finished";
    EXPECT_EQ(motion.state().temperature[0], 300);
    EXPECT_LT(motion.bridge()->sweeps(), 100U) << "of 50000";
    stop = false;
    EXPECT_TRUE(motion.advance(0.005).ok()) << "and it goes on from there";
    EXPECT_NEAR(motion.state().temperature[0], 400, 1e-6);
  }
}

/// Jumps are looked for in the last step before an output time, too, that is shorter than any other may be.
TEST(Outcomes, OutputTimesAreHitByStepsBelowTheSmallest) {
  Model model = quiet_model();
  model.bond = {.stiffness = 1e5, .threshold = 1e-3};
  Cloud cloud;
  cloud.add({0, 0, 0}, {1, 0, 0});
  cloud.add({0.1499, 0, 0}, {-1, 0, 0});  // bonded within 0.1 ms
  SteppingSettings settings;
  settings.first_step = settings.largest_step = settings.smallest_step = 1e-3;
  Motion motion(model, cloud.particles, settings);
  motion.start(cloud.state);
  const Outcome outcome = motion.advance(1e-4);
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_EQ(motion.state().time, 1e-4);
}

}  // namespace
}  // namespace superstep
