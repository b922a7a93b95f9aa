#include "integrators/press/checkpoint.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "press.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

using namespace test;

/// A little of everything: bonds in tension, currents by iteration, a moving wall, adaptive steps.
struct BusyPress {
  BusyPress() {
    model = quiet_model(0.4);
    model.gravity = 9.81;
    model.contact = {1e7, 2, {1500, 1e6}, 0.1, 0.3, 0.2};
    model.wall = model.contact;
    model.bond = {.stiffness = 5e5, .exponent = 2, .threshold = 0.12, .rule = BondRule::tension};
    model.thermal.conductivity = 1e4;
    model.thermal.wall_temperature.fill(800);
    model.electric.model = CurrentModel::averaging;
    model.electric.conductivity = 0.1;
    model.electric.absorption = 0.5;
    Phase first = model.schedule.phases().front(), second;
    first.end = 0.02;
    first.lower = 3e3;
    first.upper = 5e3;
    second = first;
    second.begin = 0.02;
    second.end = 1;
    second.upper_wall = 0.3;
    model.schedule = Schedule({first, second});
    cloud = random_cloud(80, 0.36, 51, 0.5);
  }
  Model model;
  Cloud cloud;
};

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}
bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

class Restart : public testing::TestWithParam<const char*> {};

TEST_P(Restart, GoesOnToTheLastBit) {
  const BusyPress press;
  const TemporaryFolder folder;
  SteppingSettings settings;
  settings.thermal_integrator = GetParam();
  Motion whole(press.model, press.cloud.particles, settings);
  whole.start(press.cloud.state);
  std::size_t stored = 0;
  whole.after_step = [&] {
    if (stored > 0 || whole.state().time < 0.015) return;
    stored = whole.history().size();
    write_file_atomically(folder.file("c.bin"), checkpoint_image({press.cloud.particles, whole.state(),
                                                                  whole.next_step(), whole.history()}));
  };
  ASSERT_TRUE(whole.advance(0.04).ok());
  ASSERT_GT(stored, 0U);
  ASSERT_LT(stored, whole.history().size()) << "there is something left to do";

  Checkpoint checkpoint = read_checkpoint(folder.file("c.bin"));
  EXPECT_FALSE(checkpoint.state.bonds.empty());
  EXPECT_EQ(checkpoint.particles.id, press.cloud.particles.id);
  Motion rest(press.model, press.cloud.particles, settings);
  rest.resume(std::move(checkpoint.state), checkpoint.next_step, std::move(checkpoint.history));
  ASSERT_TRUE(rest.advance(0.04).ok());
  EXPECT_TRUE(same_bits(rest.state().position, whole.state().position));
  EXPECT_TRUE(same_bits(rest.state().velocity, whole.state().velocity));
  EXPECT_TRUE(same_bits(rest.state().temperature, whole.state().temperature));
  EXPECT_TRUE(same_bits(rest.state().electric, whole.state().electric));
  EXPECT_EQ(rest.state().bonds.size(), whole.state().bonds.size());
  ASSERT_EQ(rest.history().size(), whole.history().size());
  EXPECT_EQ(rest.history().back().wall_force, whole.history().back().wall_force);
  EXPECT_EQ(rest.rejected(), whole.rejected());
}
INSTANTIATE_TEST_SUITE_P(Thermal, Restart, testing::Values("", "rkc:rtol=1e-5"));

TEST(CheckpointFile, RefusesWhatIsNotOne) {
  const TemporaryFolder folder;
  const BusyPress press;
  const std::string image = checkpoint_image({press.cloud.particles, press.cloud.state, 1e-3, {}});
  EXPECT_NO_THROW((void)read_checkpoint(folder.write("good.bin", image)));
  EXPECT_THROW((void)read_checkpoint(folder.file("absent.bin")), InputError);
  EXPECT_THROW((void)read_checkpoint(folder.write("text.bin", "id,x,y\n")), InputError);
  EXPECT_THROW((void)read_checkpoint(folder.write("short.bin", image.substr(0, image.size() / 2))),
               InputError);
  std::string flipped = image;
  flipped[image.size() / 2] = static_cast<char>(flipped[image.size() / 2] ^ 1);
  EXPECT_THROW((void)read_checkpoint(folder.write("flipped.bin", flipped)), InputError);
}

}  // namespace
}  // namespace superstep
