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

}  // namespace
}  // namespace superstep
