/// The balance of energy closes: what the wall, gravity and the current bring is what moves, is stored, is
/// dissipated and is lost.

#include "integrators/press/energy.hpp"

#include <gtest/gtest.h>

#include "press.hpp"

namespace superstep {
namespace {

using namespace test;

Cloud two_against_each_other() {
  Cloud cloud;
  cloud.add({-0.08, 0, 0}, {1.5, 0, 0});
  cloud.add({0.08, 0, 0}, {-1.5, 0, 0});
  return cloud;
}

TEST(Energy, OfAContactIsWhatItsForceStoresAndComesBack) {
  const Model model = quiet_model();
  const Cloud cloud = two_against_each_other();
  const auto motion_until = [&](double t, double step) {
    Motion motion(model, cloud.particles, fixed_step(step));
    motion.start(cloud.state);
    EXPECT_TRUE(motion.advance(t).ok());
    const Vec3 between = motion.state().position[1] - motion.state().position[0];
    return std::pair{motion.history().back(), 1 - norm(between) / 0.15};
  };
  const auto [row, strain] = motion_until(0.01, 1e-5);
  ASSERT_GT(strain, 0.01) << "pressed together";
  // The trapezoid of the power is of order 2: some 1e3 steps in contact leave 1e-5 of the energy.
  const double exact = contact_energy(1e7, 0.075, strain);
  EXPECT_NEAR(row.elastic_energy, exact, 1e-4 * exact);
  const auto [end, apart] = motion_until(0.2, 1e-5);
  ASSERT_LT(apart, 0) << "and apart again";
  EXPECT_NEAR(end.elastic_energy, 0, 1e-4 * end.kinetic_energy);
  EXPECT_EQ(end.dissipated, 0);
}

/// Damped, rubbed, dragged, pressed by a moving wall, heated by walls and a current.
struct Bed {
  Model model = quiet_model(0.3);
  Cloud cloud = random_cloud(12, 0.2, 7, 0.5);

  Bed() {
    model.gravity = 9.81;
    model.drag.coefficient = 0.1;
    for (auto* law : {&model.contact, &model.wall}) {
      law->friction = 0.2;
      law->damping = 0.2;
      law->softening = {3000, 1e6};
    }
    model.thermal.conductivity = 2e4;
    model.thermal.wall_temperature.fill(600);
    model.electric.model = CurrentModel::averaging;
    model.electric.conductivity = 0.1;
    Phase press = model.schedule.phases().front();
    press.end = 0.1;
    press.upper_wall = 0.2;
    press.lower = press.upper = 3e3;
    Phase rest = press;
    rest.begin = 0.1;
    rest.end = 1e9;
    rest.upper_wall_begin = rest.upper_wall;
    rest.lower.reset();
    rest.upper.reset();
    model.schedule = Schedule({press, rest});
  }
  [[nodiscard]] std::vector<HistoryRow> history(double step) const {
    Motion motion(model, cloud.particles, fixed_step(step));
    motion.start(cloud.state);
    const Outcome outcome = motion.advance(0.15);
    EXPECT_TRUE(outcome.ok()) << outcome.reason;
    return motion.history();
  }
};

TEST(Energy, OfABedCloses) {
  const Bed bed;
  const auto coarse = bed.history(2e-4), fine = bed.history(5e-5);
  const HistoryRow& last = fine.back();
  for (const double part : {last.wall_work, last.dissipated, last.joule_heat, std::abs(last.elastic_energy)})
    EXPECT_GT(part, 0) << "everything takes part";
  const auto of_coarse = balance_errors(coarse), of_fine = balance_errors(fine);
  // Of what is turned over; contacts last some 200 of the fine steps, and the trapezoid is of order 2 in
  // them.
  EXPECT_LT(of_fine.mechanical, 1e-5);
  EXPECT_LT(of_fine.thermal, 1e-5);
  EXPECT_LT(of_fine.mechanical, of_coarse.mechanical / 8) << "1/16 where nothing has corners";
}

/// Pressed into a floor of 400 K whose heat it takes within a part of a step.
TEST(Energy, LostThroughAThermalIntegratorIsWhatTheParticlesGained) {
  Model model = quiet_model();
  model.contact.stiffness = model.wall.stiffness = 0;
  model.thermal.conductivity = 5e6;  // time constant of 1.4 ms, steps of 5 ms
  model.thermal.wall_temperature.fill(400);
  Cloud cloud;
  cloud.add({0, 0, -1 + 0.0675});
  const double capacity = 100 * cloud.particles.mass[0];
  for (const auto scheme : {SteppingSettings::Scheme::staggered, SteppingSettings::Scheme::plain}) {
    SteppingSettings settings;
    settings.scheme = scheme;
    settings.thermal_integrator = "exponential:rtol=1e-9";
    Motion motion(model, cloud.particles, settings);
    motion.start(cloud.state);
    ASSERT_TRUE(motion.advance(0.05).ok());
    EXPECT_NEAR(motion.history().back().heat_lost, -100 * capacity, 1e-6 * 100 * capacity);
    EXPECT_LT(balance_errors(motion.history()).thermal, 1e-12);
  }
}

/// Where a phase begins that holds a particle at the temperature of its wall, all that a row says is of then.
TEST(Energy, RowsAtTheChangeOfAPhaseAgreeWithThemselves) {
  Model model = quiet_model();
  model.contact.stiffness = model.wall.stiffness = 0;
  model.thermal.conductivity = 10;
  model.thermal.wall_temperature.fill(600);
  model.electric.model = CurrentModel::averaging;
  Phase first = model.schedule.phases().front(), second = first;
  first.end = second.begin = 0.01;
  second.lower = 10;
  model.schedule = Schedule({first, second});
  Cloud cloud;
  cloud.add({0, 0, -1 + 0.074});
  cloud.add({0.5, 0, 0});
  Motion motion(model, cloud.particles, SteppingSettings{});
  motion.start(cloud.state);
  ASSERT_TRUE(motion.advance(0.01).ok());
  const HistoryRow& row = motion.history().back();
  EXPECT_EQ(motion.state().temperature[0], 600);
  EXPECT_EQ(row.max_temperature, 600);
  const double capacity = 100 * cloud.particles.mass[0];
  EXPECT_NEAR(row.heat_content, 2 * capacity * row.mean_temperature, 1e-9 * row.heat_content);
  EXPECT_LT(balance_errors(motion.history()).thermal, 1e-9) << "what held it is booked";
}

TEST(Energy, HeatBelowTheRoundingsOfTheContentTellsNothing) {
  HistoryRow begin, end;
  begin.heat_content = end.heat_content = 1e6;
  end.joule_heat = 1e-11;  // a tenth of what 1e6 J are rounded to
  EXPECT_EQ(balance_errors(std::vector{begin, end}).thermal, 0);
  end.joule_heat = 1;
  EXPECT_EQ(balance_errors(std::vector{begin, end}).thermal, 1) << "while a joule that is gone is gone";
}

/// Steps that make energy in a contact book it as elastic: once all are apart, none may be left.
TEST(Energy, ThatStaysElasticWithoutAContactIsAnError) {
  const Model model = quiet_model();
  const Cloud cloud = two_against_each_other();
  for (const double phi : {0.0, 0.5}) {
    SteppingSettings settings = fixed_step(2e-4, phi);
    Motion motion(model, cloud.particles, settings);
    motion.start(cloud.state);
    ASSERT_TRUE(motion.advance(0.1).ok());
    ASSERT_EQ(motion.network().contacts().touching(), 0U) << "apart again";
    const auto& history = motion.history();
    const double begin = kinetic_energy(cloud.particles, cloud.state);
    const double gain = history.back().kinetic_energy - begin;
    double turned_over = 0;
    for (std::size_t k = 1; k < history.size(); ++k)
      turned_over += std::abs(history[k].kinetic_energy - history[k - 1].kinetic_energy) +
                     std::abs(history[k].elastic_energy - history[k - 1].elastic_energy);
    const double error = balance_errors(history, true).mechanical;
    EXPECT_NEAR(error, std::abs(gain) / turned_over, 1e-12)
        << "all that was gained, and nothing books it away";
    if (phi == 0.5) {
      EXPECT_LT(error, 1e-3);
    } else {
      EXPECT_GT(gain, 0.01 * begin) << "phi < 0.5";
    }
    EXPECT_TRUE(conserves(model));
  }
  Model soft = model;
  soft.contact.softening = {900, 0};
  EXPECT_FALSE(conserves(soft)) << "what softens while it is pressed gives less back";
}

}  // namespace
}  // namespace superstep
