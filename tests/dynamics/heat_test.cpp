#include <gtest/gtest.h>

#include "dynamics/moving_network.hpp"
#include "integrators/press/thermal_bridge.hpp"
#include "press.hpp"
#include "rhs/network_rhs.hpp"

namespace superstep {
namespace {

using namespace test;

double heat_content(const Model& model, const Particles& particles, const State& state) {
  double sum = 0;
  for (std::size_t i = 0; i < state.size(); ++i)
    sum += particles.mass[i] * model.thermal.specific_heat * state.temperature[i];
  return sum;
}

Model warm_model() {
  Model model = quiet_model(0.4);
  model.thermal.conductivity = 1e4;
  for (std::size_t w = 0; w < wall_count; ++w)
    model.thermal.wall_temperature[w] = 400 + 100 * static_cast<double>(w);
  model.electric.model = CurrentModel::averaging;
  model.electric.conductivity = 0.1;
  model.electric.absorption = 0.5;
  Phase phase = model.schedule.phases().front();
  phase.lower = 1e4;
  model.schedule = Schedule({phase});
  return model;
}

TEST(Heat, FrozenNetworkHasTheSameRates) {
  const Model model = warm_model();
  Cloud cloud = random_cloud(150, 0.38, 7);
  const Phase& phase = model.schedule.at(0);
  MovingNetwork network(model, cloud.particles);
  network.resume(cloud.state, phase);
  network.settle(cloud.state, phase);
  std::vector<double> rate(cloud.particles.size());
  network.rates(cloud.state.temperature, rate);
  Network frozen = network.frozen_network();
  const auto node_of_row = frozen.node_of_row;
  ASSERT_LT(node_of_row.size(), cloud.particles.size()) << "some particles are held";
  ASSERT_FALSE(frozen.ghost_edges.empty());
  NetworkRhs rhs(std::move(frozen), "temperature", "K", 1);
  std::vector<double> y, dydt(node_of_row.size());
  for (const auto node : node_of_row) y.push_back(cloud.state.temperature[static_cast<std::size_t>(node)]);
  rhs(0, y, dydt);
  double largest = 0;
  for (const double value : rate) largest = std::max(largest, std::abs(value));
  for (std::size_t row = 0; row < y.size(); ++row)
    EXPECT_NEAR(dydt[row], rate[static_cast<std::size_t>(node_of_row[row])], 1e-12 * largest) << "rounding";
  for (std::size_t i = 0; i < rate.size(); ++i)
    EXPECT_TRUE(network.held()[i] < 0 || rate[i] == 0) << "held particles do not change";
}

TEST(Heat, ColumnsOfTheFrozenNetworkAscend) {
  const Model model = warm_model();
  Cloud cloud = random_cloud(120, 0.38, 8);
  MovingNetwork network(model, cloud.particles);
  network.resume(cloud.state, model.schedule.at(0));
  const Network frozen = network.frozen_network();
  ASSERT_GT(frozen.nonzeros(), 100U);
  for (std::size_t row = 0; row < frozen.size(); ++row)
    for (auto k = frozen.row_begin[row] + 1; k < frozen.row_begin[row + 1]; ++k)
      EXPECT_LT(frozen.column[static_cast<std::size_t>(k) - 1], frozen.column[static_cast<std::size_t>(k)]);
}

TEST(Heat, IsConservedWhenInsulated) {
  for (const char* spec : {"", "rkc:rtol=1e-3", "forward-euler", "exponential:rtol=1e-9"}) {
    Model model = warm_model();
    model.electric.model = CurrentModel::none;
    model.thermal.walls_conduct = false;
    const Cloud cloud = random_cloud(60, 0.38, 9);
    SteppingSettings settings;
    settings.thermal_integrator = spec;
    settings.largest_step = settings.first_step = 1e-3;
    Motion motion(model, cloud.particles, settings);
    motion.start(cloud.state);
    ASSERT_TRUE(motion.advance(0.05).ok()) << spec;
    const double before = heat_content(model, cloud.particles, cloud.state);
    EXPECT_NEAR(heat_content(model, cloud.particles, motion.state()), before, 1e-11 * before)
        << spec << ": rounding of some hundred steps";
    double moved = 0;
    for (std::size_t i = 0; i < cloud.particles.size(); ++i)
      moved = std::max(moved, std::abs(motion.state().temperature[i] - cloud.state.temperature[i]));
    EXPECT_GT(moved, 1) << "heat did flow";
  }
}

TEST(Heat, EveryIntegratorGoesTheSameWay) {
  // Same motion for all: the temperature does not act back on it.
  const Model model = warm_model();
  const Cloud cloud = random_cloud(80, 0.38, 10);
  const auto finish = [&](const std::string& spec) {
    SteppingSettings settings;
    settings.thermal_integrator = spec;
    settings.largest_step = settings.first_step = 1e-3;
    Motion motion(model, cloud.particles, settings);
    motion.start(cloud.state);
    const Outcome outcome = motion.advance(0.03);
    EXPECT_TRUE(outcome.ok()) << outcome.reason;
    return motion.state().temperature;
  };
  const auto exact = finish("exponential:rtol=1e-12");
  for (const char* spec : {"rkc:rtol=1e-6", "rkl:rtol=1e-6", "cvode:rtol=1e-8", "trapezoidal:rtol=1e-6"}) {
    const auto other = finish(spec);
    double worst = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) worst = std::max(worst, std::abs(other[i] - exact[i]));
    EXPECT_LT(worst, 0.1) << spec << ": 1e-6 of a span of some 1000 K in each of 30 or more updates";
    EXPECT_GT(worst, 0) << "it is another method indeed";
  }
}

TEST(Heat, ParticlesThatOnlyTouchWallsAreIntegratedToo) {
  // No edge between free nodes: the Jacobian is a diagonal. Exact: T = T_w + (T_0 - T_w) exp(-t K/C).
  Model model = quiet_model(0.1);
  model.thermal.conductivity = 1e4;
  Cloud cloud;
  cloud.add({-0.03, 0, 0}, {}, 0.075, 300);
  model.wall.stiffness = 0;  // it stays where it is
  model.thermal.wall_temperature.fill(900);
  const double area = std::numbers::pi * (0.075 * 0.075 - 0.07 * 0.07);
  const double rate = 1e4 * area / 0.07 / (cloud.particles.mass[0] * 100);
  for (const char* spec :
       {"cvode:rtol=1e-8", "trapezoidal:rtol=1e-8", "exponential:rtol=1e-9", "rkc:rtol=1e-8"}) {
    SteppingSettings settings;
    settings.thermal_integrator = spec;
    Motion motion(model, cloud.particles, settings);
    motion.start(cloud.state);
    const Outcome outcome = motion.advance(0.1);
    ASSERT_TRUE(outcome.ok()) << spec << ": " << outcome.reason;
    EXPECT_NEAR(motion.state().temperature[0], 900 - 600 * std::exp(-rate * 0.1), 1e-3)
        << spec << ": 1e-8 of 600 K in each of some 20 steps, with room for local errors that add up";
  }
}

TEST(Heat, PhiRuleAndBridgeMeetAsTheStepShrinks) {
  // The bridge splits heat from motion, an error of first order in the step.
  const Model model = warm_model();
  const Cloud cloud = random_cloud(80, 0.38, 10);
  const auto finish = [&](const std::string& spec, double step) {
    SteppingSettings settings = fixed_step(step, 0.5, 1e-10);
    settings.thermal_integrator = spec;
    Motion motion(model, cloud.particles, settings);
    motion.start(cloud.state);
    EXPECT_TRUE(motion.advance(0.004).ok());
    return motion.state().temperature;
  };
  const auto difference = [&](double step) {
    const auto a = finish("", step), b = finish("exponential:rtol=1e-12", step);
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return sum;
  };
  const double coarse = difference(2e-4), fine = difference(5e-5);
  EXPECT_GT(coarse / fine, 2.5) << "first order: 4, less what touches a wall one step sooner or later";
}

}  // namespace
}  // namespace superstep
