/// Orders in time, jumps and necks included, against an integration that shares no code.

#include <gtest/gtest.h>

#include "dynamics/contacts/bond_registry.hpp"
#include "oracle.hpp"
#include "press.hpp"

namespace superstep {
namespace {

using namespace test;
using oracle::Few;
using oracle::Laws;

struct Scene {
  std::string name;
  Laws laws;
  Cloud cloud;
  double t_end;
  int switches;      ///< that have to happen on the way
  int coarse = 100;  ///< steps, few enough for a large error and enough to part the switches

  friend void PrintTo(const Scene& scene, std::ostream* out) { *out << scene.name; }
};

Model model_of(const Laws& laws) {
  Model model = quiet_model(1);
  model.gravity = laws.g;
  model.drag.coefficient = laws.drag;
  model.contact = {laws.K, 2, {laws.T_star, laws.K_lim}, laws.mu, laws.v_s, laws.zeta};
  model.wall = model.contact;
  model.thermal.conductivity = laws.kappa;
  model.thermal.specific_heat = laws.C;
  model.thermal.wall_temperature.fill(laws.T_wall);
  if (laws.bond != Laws::none)
    model.bond = {.stiffness = laws.K_b,
                  .exponent = 2,
                  .threshold = laws.E_star,
                  .rule = laws.bond == Laws::overlap   ? BondRule::overlap
                          : laws.bond == Laws::tension ? BondRule::tension
                                                       : BondRule::rest_length,
                  .rupture = laws.E_r,
                  .softening = {laws.Tb_star, laws.Kb_lim},
                  .unloading = laws.w,
                  .damping = laws.zeta_b,
                  .growth = {laws.coble ? NeckGrowth::Mechanism::coble : NeckGrowth::Mechanism::frenkel,
                             laws.k_ref, laws.Q, laws.T_ref, laws.p_s}};
  if (laws.floor) {
    model.box.min.z = 0;
    Phase phase = model.schedule.phases().front();
    if (laws.J > 0) phase.lower = laws.J;
    model.schedule = Schedule({phase});
  }
  if (laws.J > 0) {
    model.electric.model = CurrentModel::averaging;
    model.electric.conductivity = laws.sigma;
    model.electric.absorption = laws.a;
  }
  return model;
}

Few exact_of(const Scene& scene) {
  std::vector<oracle::Body> bodies;
  for (std::size_t i = 0; i < scene.cloud.particles.size(); ++i) {
    const Vec3 x = scene.cloud.state.position[i], v = scene.cloud.state.velocity[i];
    bodies.push_back({{x.x, x.y, x.z},
                      {v.x, v.y, v.z},
                      scene.cloud.state.temperature[i],
                      scene.cloud.particles.radius[i],
                      scene.cloud.particles.mass[i]});
  }
  Few exact(scene.laws, bodies);
  exact.advance(scene.t_end, scene.t_end / 10'000);
  return exact;
}

struct Errors {
  double position, velocity, temperature;
};

Errors errors_of(const Scene& scene, const Few& exact, int steps,
                 SteppingSettings::Control control = SteppingSettings::Control::steady) {
  const Model model = model_of(scene.laws);
  SteppingSettings settings = fixed_step(scene.t_end / steps);
  settings.control = control;
  Motion motion(model, scene.cloud.particles, settings);
  motion.start(scene.cloud.state);
  const Outcome outcome = motion.advance(scene.t_end);
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
  Errors errors{0, 0, 0};
  for (std::size_t i = 0; i < motion.state().size(); ++i) {
    const Vec3 x = motion.state().position[i], v = motion.state().velocity[i];
    errors.position = std::max(
        errors.position, norm(x - Vec3{exact.position(i, 0), exact.position(i, 1), exact.position(i, 2)}));
    errors.velocity = std::max(
        errors.velocity, norm(v - Vec3{exact.velocity(i, 0), exact.velocity(i, 1), exact.velocity(i, 2)}));
    errors.temperature =
        std::max(errors.temperature, std::abs(motion.state().temperature[i] - exact.temperature(i)));
  }
  return errors;
}

Laws hot_laws() {
  Laws laws;
  laws.K = 1e8;
  laws.T_star = 1500;
  laws.K_lim = 1e7;
  laws.zeta = 0.1;
  laws.mu = 0.1;
  laws.v_s = 0.5;
  laws.kappa = 2e5;
  laws.T_ref = 900;
  return laws;
}

Cloud two() {
  Cloud cloud;
  cloud.add({-0.074, 0, 0}, {2, 0.3, 0}, 0.075, 900);
  cloud.add({0.074, 0.01, 0}, {-2, 0, 0.1}, 0.075, 600);
  return cloud;
}

Cloud five() {
  Cloud cloud = two();
  cloud.add({0, 0.128, 0.01}, {0.2, -1.5, 0}, 0.07, 1100);
  cloud.add({0.01, -0.13, 0.02}, {0, 1.2, 0.3}, 0.08, 700);
  cloud.add({0.01, 0, 0.131}, {0.1, 0, -1.7}, 0.075, 800);
  return cloud;
}

Scene overlap_scene() {
  Laws laws = hot_laws();
  laws.bond = Laws::overlap;
  laws.K_b = 4e7;
  laws.Tb_star = 1500;
  laws.Kb_lim = 4e6;
  laws.E_star = 0.05;
  return {"overlap", laws, two(), 0.03, 2};
}
Scene tension_scene() {
  Scene scene = overlap_scene();
  scene.name = "tension";
  scene.laws.bond = Laws::tension;
  scene.laws.E_r = 0.02;
  scene.t_end = 0.04;
  return scene;
}
Scene neck_scene(bool many) {
  Scene scene = overlap_scene();
  Laws& laws = scene.laws;
  scene.name = many ? "neck of five" : "neck";
  laws.bond = Laws::neck;
  laws.K_b = 1e7;
  laws.E_star = 0.02;
  laws.E_r = 0.2;
  laws.w = 0.02;
  laws.k_ref = 60;
  laws.Q = 4e4;
  laws.p_s = 1e6;
  laws.zeta_b = 0.1;
  if (many) scene.cloud = five();
  scene.t_end = 0.03;
  scene.switches = 1;
  return scene;
}
Scene held_scene() {
  Laws laws = hot_laws();
  laws.floor = true;
  laws.T_wall = 1000;
  laws.J = 3e3;
  laws.g = 9.81;
  Cloud cloud;  // the lower one meets the wall after some 2 ms; the two touch all the way
  cloud.add({0, 0, 0.078}, {0, 0, -1.5}, 0.075, 400);
  cloud.add({0.005, 0, 0.215}, {0.1, 0, -1.5}, 0.075, 500);
  return {"held by a wall", laws, cloud, 0.012, 1};
}

Scene lit_scene() {
  Scene scene =
      held_scene();  // the lower one lies at the wall; the upper one falls on it and carries current
  scene.name = "lit by touching";
  scene.cloud = {};
  scene.cloud.add({0, 0, 0.074}, {0, 0, 0}, 0.075, 400);
  scene.cloud.add({0.005, 0, 0.2266}, {0.1, 0, -1.5}, 0.075, 500);
  return scene;
}
Scene ten_scene() {
  Scene scene = tension_scene();
  scene.name = "tension of ten";
  scene.cloud = five();
  for (const Vec3 at :
       {Vec3{0.15, 0.02, 0}, {-0.15, 0, 0.01}, {0.02, 0.27, 0}, {0, -0.28, 0.03}, {0, 0.01, 0.28}})
    scene.cloud.add(at, -10.0 * at, 0.075, 500 + 1000 * at.x);
  scene.t_end = 0.02;
  scene.switches = 20;
  scene.coarse = 400;
  return scene;
}

class OrderOf : public testing::TestWithParam<Scene> {};

TEST_P(OrderOf, IsTwoForPositionsVelocitiesAndTemperatures) {
  const Scene& scene = GetParam();
  const Few exact = exact_of(scene);
  ASSERT_GE(exact.switched(), scene.switches) << "jumps take part";
  // Over a factor of eight in the step: where a corner of a law falls within its step wavers from step to
  // step.
  const Errors coarse = errors_of(scene, exact, scene.coarse),
               fine = errors_of(scene, exact, 8 * scene.coarse);
  ASSERT_GT(fine.velocity, 1e-9) << "far above the iteration's tolerance and the oracle's error";
  const auto order = [](double a, double b) { return std::log2(a / b) / 3; };
  EXPECT_GT(order(coarse.position, fine.position), 1.8) << coarse.position << " " << fine.position;
  EXPECT_GT(order(coarse.velocity, fine.velocity), 1.8) << coarse.velocity << " " << fine.velocity;
  EXPECT_GT(order(coarse.temperature, fine.temperature), 1.8)
      << coarse.temperature << " " << fine.temperature;
}

INSTANTIATE_TEST_SUITE_P(Switches, OrderOf,
                         testing::Values(overlap_scene(), tension_scene(), neck_scene(false),
                                         neck_scene(true), held_scene(), lit_scene(), ten_scene()),
                         [](const auto& one) {
                           std::string name = one.param.name;
                           for (char& c : name) c = c == ' ' ? '_' : c;
                           return name;
                         });

TEST(Order, OfThePrintedControlIsOneWhereForcesJump) {
  const Scene scene = overlap_scene();
  const Few exact = exact_of(scene);
  const auto paper = SteppingSettings::Control::paper;
  // A jump at the end of its step is late by anything from nothing to h: the worst of some steps goes with h.
  const auto worst = [&](int steps) {
    double largest = 0;
    for (const int more : {0, 7, 13, 20})
      largest = std::max(largest, errors_of(scene, exact, steps + more, paper).velocity);
    return largest;
  };
  const double order = std::log2(worst(400) / worst(3200)) / 3;
  EXPECT_GT(order, 0.6);
  EXPECT_LT(order, 1.5);
}

}  // namespace
}  // namespace superstep
