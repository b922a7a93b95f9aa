/// The story of the example of Zohdi (2014), section 7, as the case file tells it.

#include <gtest/gtest.h>

#include "case/press/press.hpp"
#include "core/text/text_file.hpp"
#include "press.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

using namespace test;

struct End {
  double fraction, temperature;
  std::int64_t bonds;
};

std::vector<End> phase_ends(const Press& one, Motion& motion) {
  motion.start(one.state);
  std::vector<End> ends;
  for (const auto& phase : one.model.schedule.phases()) {
    const Outcome outcome = motion.advance(phase.end);
    EXPECT_TRUE(outcome.ok()) << outcome.reason;
    const auto& row = motion.history().back();
    ends.push_back({row.volume_fraction, row.mean_temperature, row.bonds});
  }
  return ends;
}

/// 250 particles in a quarter of the box: the same depth of the bed.
TEST(Example, PoursPressesHeatsBondsAndSpringsBack) {
  const Press one = load_press(std::string(SUPERSTEP_SOURCE_DIR) + "/cases/sintering_small.toml");
  Motion motion(one.model, one.particles, one.stepping);
  const auto ends = phase_ends(one, motion);
  enum : std::size_t { pour, press, hold, release };
  ASSERT_EQ(ends.size(), 4U);
  EXPECT_GT(ends[pour].fraction, 0.50);
  EXPECT_LT(ends[pour].fraction, 0.60);
  EXPECT_GT(ends[press].fraction, 0.97) << "near 1";
  EXPECT_LT(ends[press].fraction, 1.03);
  EXPECT_LT(ends[release].fraction, 0.99 * ends[hold].fraction) << "springs back somewhat";
  EXPECT_LT(1 - ends[release].fraction, 0.85 * (1 - ends[pour].fraction))
      << "but its porosity stays 15 % below that of the poured bed";
  EXPECT_GT(ends[press].temperature, ends[pour].temperature) << "heated from both walls and by the current";
  EXPECT_GT(ends[hold].temperature, ends[press].temperature);
  EXPECT_LT(ends[release].temperature, ends[hold].temperature) << "the current is off";
  EXPECT_GT(ends[hold].bonds, ends[pour].bonds);
  EXPECT_LT(motion.history().size(), 20'000U) << "the steps did not collapse";
}

}  // namespace
}  // namespace superstep
