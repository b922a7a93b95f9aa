/// What presses leave in folders that hold something already, and what `info` says of several materials.

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "bench/press/motion_schemes.hpp"
#include "support/program_fixture.hpp"
#include "support/small_press.hpp"

namespace superstep {
namespace {

using Json = nlohmann::json;

class PressFiles : public test::Program {
 protected:
  void SetUp() override {
    (void)test::small_press(folder_);
    text_ = folder_.read("press.toml");
  }
  void changed(const std::string& name, const std::string& from, const std::string& to) {
    std::string text = text_;
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    folder_.write(name, text.replace(at, from.size(), to));
  }
  std::string text_;
};

TEST_F(PressFiles, ARestartSaysOfItsRunWhatOneRunWouldHaveSaid) {
  const std::string times = "t_end = 0.04\noutput_times = [0.02, 0.04]";
  changed("whole.toml", times, "t_end = 0.04\noutput_times = [0.01, 0.02, 0.03, 0.04]");
  changed("part.toml", times, "t_end = 0.025\noutput_times = [0.01, 0.02, 0.025]");
  ASSERT_EQ(run("run whole.toml --vtk --out whole"), 0) << err();
  ASSERT_EQ(run("run part.toml --vtk --checkpoint 0.025 --out part"), 0) << err();
  // As after an interruption at 0.025 s, which has no output time: neither has it a snapshot or a frame.
  for (const char* name : {"snapshots/particles_0002.csv", "vtk/particles_0003.vtp", "vtk/contacts_0003.vtp"})
    ASSERT_TRUE(std::filesystem::remove(folder_.file(std::string("part/") + name))) << name;
  ASSERT_EQ(run("run whole.toml --vtk --restart part/checkpoint.bin --out part"), 0) << err();
  const auto whole = Json::parse(folder_.read("whole/run.json")),
             part = Json::parse(folder_.read("part/run.json"));
  EXPECT_EQ(part["motion"]["snapshots"].size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(part["motion"]["snapshots"][k]["file"], whole["motion"]["snapshots"][k]["file"]);
    EXPECT_EQ(part["motion"]["snapshots"][k]["time"], whole["motion"]["snapshots"][k]["time"]);
  }
  EXPECT_NE(part.dump().find("\"snapshots/particles_0000.csv\""), std::string::npos);
  EXPECT_EQ(folder_.read("part/vtk/particles.pvd"), folder_.read("whole/vtk/particles.pvd"));
  // Into an empty folder: a first frame, and the snapshots that are there.
  ASSERT_EQ(run("run whole.toml --vtk --restart part/checkpoint.bin --out new"), 0) << err();
  EXPECT_EQ(Json::parse(folder_.read("new/run.json"))["motion"]["snapshots"].size(), 2U);
  EXPECT_NE(folder_.read("new/vtk/particles.pvd").find("timestep=\"0.025\""), std::string::npos);
}

/// A run may end between a checkpoint and the files of the same instant.
TEST_F(PressFiles, ARestartAtAnOutputTimeWritesWhatIsOwedThere) {
  const std::string times = "t_end = 0.04\noutput_times = [0.02, 0.04]";
  changed("whole.toml", times, "t_end = 0.04\noutput_times = [0.01, 0.02, 0.03, 0.04]");
  changed("part.toml", times, "t_end = 0.02\noutput_times = [0.01, 0.02]");
  ASSERT_EQ(run("run whole.toml --vtk --out whole"), 0) << err();
  ASSERT_EQ(run("run part.toml --vtk --checkpoint 0.02 --out part"), 0) << err();
  const std::string owed = "snapshots/particles_0001.csv";
  ASSERT_TRUE(std::filesystem::remove(folder_.file("part/" + owed)));
  ASSERT_EQ(run("run whole.toml --vtk --restart part/checkpoint.bin --out part"), 0) << err();
  EXPECT_EQ(folder_.read("part/" + owed), folder_.read("whole/" + owed));
  EXPECT_EQ(Json::parse(folder_.read("part/run.json"))["motion"]["snapshots"],
            Json::parse(folder_.read("whole/run.json"))["motion"]["snapshots"]);
  for (const char* name : {"vtk/particles.pvd", "vtk/particles_0002.vtp", "vtk/contacts_0002.vtp"})
    EXPECT_EQ(folder_.read(std::string("part/") + name), folder_.read(std::string("whole/") + name)) << name;
}

/// Work that was done is counted, whoever did it.
TEST_F(PressFiles, CountsWhatAThermalIntegratorAndTheCurrentSolvedFor) {
  const auto counts_of = [&](const std::string& name) {
    EXPECT_EQ(run("run " + name + ".toml --quiet --out " + name), 0) << err();
    return Json::parse(folder_.read(name + "/run.json"))["counts"];
  };
  changed("plain.toml", "[dynamics]\n", "[dynamics]\nthermal_integrator = \"rkc:rtol=1e-4\"\n");
  const auto plain = counts_of("plain");
  EXPECT_GT(plain["rhs"], 0);
  for (const char* none : {"jacobians", "factorizations", "solves", "potential_solves"})
    EXPECT_EQ(plain[none], 0) << none;
  changed("klu.toml", "[dynamics]\n",
          "[dynamics]\nthermal_integrator = \"trapezoidal:rtol=1e-4,solver=klu\"\n");
  const auto klu = counts_of("klu");
  for (const char* some : {"jacobians", "factorizations", "solves"}) EXPECT_GT(klu[some], 0) << some;
  changed("volts.toml", "current = { lower = 1e4, upper = 1e4 }", "potential = { lower = 0.0, upper = 1.0 }");
  text_ = folder_.read("volts.toml");
  changed("volts.toml", "[electric]\n", "[electric]\nmodel = \"potential\"\n");
  EXPECT_GT(counts_of("volts")["potential_solves"], 0);
}

TEST_F(PressFiles, AnExportWithoutBondsLeavesNoneOfAnEarlierOne) {
  changed("loose.toml", "[dynamics.bond]\nstiffness = 1e6\nthreshold = 0.05\n", "");
  ASSERT_EQ(run("run press.toml --out out --export-packing p.csv"), 0) << err();
  ASSERT_TRUE(folder_.has("p.bonds.csv"));
  ASSERT_EQ(run("run loose.toml --out out --export-packing p.csv"), 0) << err();
  EXPECT_FALSE(folder_.has("p.bonds.csv"));
  EXPECT_NE(err().find("removed p.bonds.csv"), std::string::npos) << err();
  folder_.write("p.bonds.csv", "of the user\n");
  ASSERT_EQ(run("run loose.toml --out out --export-packing p.csv"), 0) << err();
  EXPECT_EQ(folder_.read("p.bonds.csv"), "of the user\n");
}

TEST_F(PressFiles, InfoSpeaksOfTheMaterialsThatThereAre) {
  folder_.write("two.toml", R"(t_end = 1e-4
[[materials]]
name = "a"
density = 2000.0
thermal = { conductivity = 1.0e4, specific_heat = 100.0 }
electric = { conductivity = 0.1 }
hardness = 4.0
[[materials]]
name = "b"
density = 8000.0
thermal = { conductivity = 1.0, specific_heat = 1000.0 }
electric = { conductivity = 10.0 }
[thermal]
initial = 300.0
walls = 300.0
[electric]
[dynamics.box]
min = [-1,-1,-1]
max = [1,1,1]
[dynamics.particles]
list = [ { position = [0, 0, 0.5], radius = 0.075, material = "a" },
         { position = [0, 0, -0.5], radius = 0.075, material = "b" } ]
[dynamics.contact]
stiffness = 1e7
[dynamics.wall]
stiffness = 1e7
[[dynamics.phases]]
name = "x"
until = 1e-4
current = { lower = 1e4, upper = 1e4 }
)");
  ASSERT_EQ(run("info two.toml --json"), 0) << err();
  const auto info = Json::parse(out());
  // Everything is fastest in a: 2000 kg/m3, 100 J/(kg K), 1e4 W/(m K), 0.1 S/m, four times as hard.
  const double pi = std::numbers::pi, r = 0.075, volume = 4.0 / 3.0 * pi * r * r * r, mass = 2000 * volume;
  const double d = 1.8 * r, area = pi * (r * r - d * d / 4);
  const auto near = [](double value, double expected) { EXPECT_NEAR(value, expected, 1e-9 * expected); };
  near(info["pair_heat_exchange_s"], mass * 100 * d / (1e4 * area));
  near(info["joule_rate"], 1e8 * volume / 0.1 / (mass * 100));
  EXPECT_EQ(info["forecast"]["steps"], 1);
  EXPECT_EQ(info["forecast"]["step_s"], 1e-4);
  const double hard = info["pair_oscillation_s"];
  std::string text = folder_.read("two.toml");
  folder_.write("two.toml", text.replace(text.find("hardness = 4.0"), 14, "hardness = 1.0"));
  ASSERT_EQ(run("info two.toml --json"), 0) << err();
  near(Json::parse(out())["pair_oscillation_s"], 2 * hard);
}

TEST_F(PressFiles, AnExportIsNotWrittenOverItsCase) {
  EXPECT_EQ(run("run press.toml --export-packing ./press.toml"), 2);
  EXPECT_NE(err().find("is the case itself"), std::string::npos) << err();
  EXPECT_EQ(folder_.read("press.toml"), text_);
}

TEST_F(PressFiles, SchemesAreComparedWithStepsBelowTheSmallestOfTheCase) {
  folder_.write("coarse.toml", text_ + "[dynamics.stepping]\nsmallest_step = 1e-5\n");
  ASSERT_EQ(run("bench coarse.toml --repetitions 1 --out coarse"), 0) << err();  // its reference: 1.25e-6 s
  EXPECT_EQ(folder_.read("coarse/motion.csv").find(",failed,"), std::string::npos) << out();
}

TEST_F(PressFiles, ASchemeThatDidNotComeToTheEndHasNoErrorThere) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  MotionComparison comparison;
  MotionRow& row = comparison.rows.emplace_back();
  row.error_position = row.error_temperature = none;
  EXPECT_EQ(motion_table(comparison).find("nan"), std::string::npos) << motion_table(comparison);
  const std::string csv = motion_csv(load_press(folder_.file("press.toml")), comparison);
  EXPECT_NE(csv.find("0,0,,,0\n"), std::string::npos) << csv;
}

TEST_F(PressFiles, TimesOfWhatNeverHappensAreNotZero) {
  std::string text = read_text_file(SUPERSTEP_SOURCE_DIR "/cases/sintering_two_particles.toml");
  for (auto at = text.find("= 1e7"); at != std::string::npos; at = text.find("= 1e7"))
    text.replace(at, 5, "= 0");
  folder_.write("still.toml", text);  // neither stiffness nor conductivity
  ASSERT_EQ(run("info still.toml --json"), 0) << err();
  const auto info = Json::parse(out());
  EXPECT_TRUE(info["pair_oscillation_s"].is_null() && info["pair_heat_exchange_s"].is_null()) << info;
  ASSERT_EQ(run("info still.toml"), 0) << err();
  EXPECT_NE(out().find("never: nothing repels"), std::string::npos) << out();
}

}  // namespace
}  // namespace superstep
