#include "integrators/press/checkpoint.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "integrators/press/model_description.hpp"
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

TEST(ModelDescription, TellsPressesApartButNotWhatIsStillToCome) {
  const BusyPress press;
  const double t = 0.015;
  const std::string here = model_description(press.model, t);
  const auto differs = [&](auto change) {
    Model other = press.model;
    change(other);
    return model_description(other, t) != here;
  };
  EXPECT_FALSE(differs([](Model&) {}));
  EXPECT_TRUE(differs([](Model& m) { m.gravity += 1e-15; })) << "to the last bit";
  EXPECT_TRUE(differs([](Model& m) { m.contact.damping += 0.1; }));
  EXPECT_TRUE(differs([](Model& m) { m.wall.exponent = 1.5; }));
  EXPECT_TRUE(differs([](Model& m) { m.bond.rule = BondRule::overlap; }));
  EXPECT_TRUE(differs([](Model& m) { m.bond.rupture *= 2; }));
  EXPECT_TRUE(differs([](Model& m) { m.drag.medium_velocity.y = 1; }));
  EXPECT_TRUE(differs([](Model& m) { m.thermal.walls_conduct = !m.thermal.walls_conduct; }));
  EXPECT_TRUE(differs([](Model& m) { m.electric.absorption *= 0.5; }));
  EXPECT_TRUE(differs([](Model& m) { m.box.min.x -= 1; }));
  const auto with_phases = [](Model& m, auto change) {
    auto phases = m.schedule.phases();
    change(phases);
    m.schedule = Schedule(std::move(phases));
  };
  EXPECT_TRUE(differs([&](Model& m) { with_phases(m, [](auto& p) { p[0].upper_wall_begin -= 0.001; }); }));
  EXPECT_FALSE(differs([&](Model& m) {
    with_phases(m, [](auto& p) {
      Phase more = p.back();
      more.begin = p.back().end;
      more.end = more.begin + 1;
      more.upper_wall_begin = more.upper_wall;
      p.push_back(more);
    });
  })) << "a press may go on for longer than was planned";
  EXPECT_FALSE(differs([](Model& m) { m.electric.tolerance *= 0.1; })) << "of the method";
}

TEST(ModelDescription, AMessageShowsWhereLongLinesDiffer) {
  const BusyPress press;
  Model other = press.model;
  auto phases = other.schedule.phases();
  phases.back().upper_wall -= 0.05;
  other.schedule = Schedule(std::move(phases));
  Model law = press.model;
  law.electric.saturation = {1.0 / 3, 2.0 / 3, 1e3 / 3, 1.0 / 7, 2.0 / 7, 3.0 / 7};
  Model other_law = law;
  other_law.electric.saturation.reference_field = 4.0 / 7;
  const auto refusal = [](const Model& before, const Model& after) {
    Checkpoint stored;
    stored.model = model_description(before, 0.015);
    return test::message_of<InputError>([&] { require_same_model(stored, after, "c.bin", "case.toml"); });
  };
  const std::string of_wall = refusal(press.model, other), of_law = refusal(law, other_law);
  EXPECT_NE(of_wall.find("'dynamics.phases.lowest ... refers to = 0.3'"), std::string::npos) << of_wall;
  EXPECT_NE(of_wall.find("refers to = 0.25'"), std::string::npos) << of_wall;
  EXPECT_NE(of_law.find("0.428571"), std::string::npos) << of_law;
  EXPECT_NE(of_law.find("0.571428"), std::string::npos) << of_law;
}

TEST(ModelDescription, AHistoryWithPhasesThatACaseLacksIsRefused) {
  const BusyPress press;
  Checkpoint stored{press.cloud.particles, press.cloud.state, 1e-3, {}, ""};
  stored.model = model_description(press.model, stored.state.time);
  EXPECT_NO_THROW(require_same_model(stored, press.model, "c.bin", "case.toml"));
  stored.history.emplace_back().phase = static_cast<std::int32_t>(press.model.schedule.phases().size());
  EXPECT_THROW(require_same_model(stored, press.model, "c.bin", "case.toml"), InputError);
  stored.history.back().phase = -1;
  EXPECT_THROW(require_same_model(stored, press.model, "c.bin", "case.toml"), InputError);
}

TEST(CheckpointFile, WhatCannotBeReadIsAnInputError) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("b", folder.file("a"));
  std::filesystem::create_symlink("a", folder.file("b"));
  std::filesystem::create_directory(folder.file("folder"));
  for (const std::string& path : {folder.file("a"), folder.file("folder"), folder.file("a/b"),
                                  folder.file(std::string(5000, 'x')), std::string("/dev/zero")})
    EXPECT_NE(test::message_of<InputError>([&] { (void)read_checkpoint(path); }), "") << path.substr(0, 80);
}

TEST(CheckpointFile, AChecksumThatFitsIsNotEnough) {
  const TemporaryFolder folder;
  const BusyPress press;
  const auto refuses = [&](auto spoil) {
    Checkpoint stored{press.cloud.particles, press.cloud.state, 1e-3, {}, ""};
    spoil(stored);
    const std::string file = folder.write("spoilt.bin", checkpoint_image(stored));
    return !test::message_of<InputError>([&] { (void)read_checkpoint(file); }).empty();
  };
  EXPECT_FALSE(refuses([](Checkpoint&) {}));
  EXPECT_TRUE(refuses([](Checkpoint& c) { c.state.velocity.pop_back(); }));
  EXPECT_TRUE(refuses([](Checkpoint& c) { c.state.temperature.clear(); }));
  EXPECT_TRUE(refuses([](Checkpoint& c) { c.state.electric.assign(3, 0.0); }));
  EXPECT_TRUE(refuses([](Checkpoint& c) { c.particles.mass.push_back(1); }));
  EXPECT_TRUE(refuses([](Checkpoint& c) { c.state.position[0].y = NAN; }));
  EXPECT_TRUE(refuses([](Checkpoint& c) { c.state.time = INFINITY; }));
  EXPECT_TRUE(refuses([](Checkpoint& c) {
    c.state.bonds.push_back({0, 80, 0.1, 0.0});
  })) << "there are 80 particles";
  EXPECT_TRUE(refuses([](Checkpoint& c) { c.state.bonds.push_back({-1, 2, 0.1, 0.0}); }));
}

TEST(CheckpointFile, RefusesWhatIsNotOne) {
  const TemporaryFolder folder;
  const BusyPress press;
  const std::string image = checkpoint_image({press.cloud.particles, press.cloud.state, 1e-3, {}});
  EXPECT_NO_THROW((void)read_checkpoint(folder.write("good.bin", image)));
  EXPECT_THROW((void)read_checkpoint(folder.file("absent.bin")), InputError);
  EXPECT_THROW((void)read_checkpoint(folder.write("text.bin", "id,x,y\n")), InputError);
  EXPECT_THROW((void)read_checkpoint(folder.write("short.bin", image.substr(0, image.size() / 2))),
               InputError);
  std::string older = image;
  const std::size_t digit = std::string("superstep checkpoint ").size();
  older[digit] = '2';
  const std::string message =
      test::message_of<InputError>([&] { (void)read_checkpoint(folder.write("older.bin", older)); });
  EXPECT_NE(message.find("is a checkpoint of version 2, and this program reads version"), std::string::npos)
      << message;
  std::string flipped = image;
  flipped[image.size() / 2] = static_cast<char>(flipped[image.size() / 2] ^ 1);
  EXPECT_THROW((void)read_checkpoint(folder.write("flipped.bin", flipped)), InputError);
}

}  // namespace
}  // namespace superstep
