/// How long a press takes, said beforehand, beside what it takes.

#include "bench/press/press_forecast.hpp"

#include <gtest/gtest.h>

#include "integrators/press/motion.hpp"
#include "support/program_fixture.hpp"
#include "support/small_press.hpp"

namespace superstep {
namespace {

/// Steps of a run over steps foreseen.
double foreseen(const Press& press) {
  dynamics::Motion motion(press.model, press.particles, press.stepping);
  motion.start(press.state);
  EXPECT_TRUE(motion.advance(press.t_end).ok());
  return static_cast<double>(motion.history().size() - 1) / forecast_press(press).steps;
}

TEST(PressForecast, IsOfTheRightSize) {
  const std::string cases = SUPERSTEP_SOURCE_DIR "/cases/";
  for (const char* name : {"sintering_small", "sintering_column", "sintering_two_particles"}) {
    const double ratio = foreseen(load_press(cases + name + ".toml"));
    EXPECT_GT(ratio, 1.0 / 3) << name;
    EXPECT_LT(ratio, 3) << name;
  }
}

/// Where particles touch already, the bed says how long its steps may be, under either scheme.
TEST(PressForecast, OfABedIsThatOfItsContacts) {
  const test::CaseFolder folder;
  std::string rows = "id,x,y,z,radius\n";
  for (int k = 0; k < 64; ++k)
    rows += fmt::format("{},{},{},{},1e-3\n", k, 1e-3 + 1.98e-3 * (k % 4), 1e-3 + 1.98e-3 * (k / 4 % 4),
                        1e-3 + 1.98e-3 * (k / 16));
  folder.write("bed.csv", rows);
  for (const char* scheme : {"staggered", "plain"}) {
    const double ratio = foreseen(load_press(folder.write(
        "bed.toml",
        fmt::format(
            "t_end = 5e-4\n[material]\ndensity = 5910\n[thermal]\nconductivity = 1\nspecific_heat = 640\n"
            "initial = 300\nwalls = 300\n[dynamics.box]\nmin = [0, 0, 0]\nmax = [7.94e-3, 7.94e-3, 8e-3]\n"
            "[dynamics.particles]\nfile = \"bed.csv\"\nmax_overlap = 0.05\n[dynamics.contact]\n"
            "stiffness = 1e9\ndamping = 0.3\n[dynamics.wall]\nstiffness = 1e9\ndamping = 0.3\n"
            "[[dynamics.phases]]\nname = \"press\"\nuntil = 5e-4\nupper_wall = 7.8e-3\n"
            "[dynamics.stepping]\nscheme = \"{}\"\n",
            scheme))));
    EXPECT_GT(ratio, 1.0 / 3) << scheme;
    EXPECT_LT(ratio, 3) << scheme;
  }
}

using test::Program;

TEST_F(Program, InfoOfAPressSaysAboutHowLongItTakes) {
  std::string text = read_text_file(test::small_press(folder_));
  ASSERT_EQ(run("info press.toml"), 0) << err();
  EXPECT_NE(out().find("a run takes about                  1 s of CPU time\n"), std::string::npos) << out();
  ASSERT_EQ(run("info press.toml --json"), 0) << err();
  EXPECT_NE(out().find("\"forecast\""), std::string::npos) << out();
  for (const std::string key : {"t_end", "until"})
    text.replace(text.find(key + " = 0.04"), key.size() + 7, key + " = 4e6");
  folder_.write("long.toml", text);
  ASSERT_EQ(run("info long.toml"), 0) << err();
  EXPECT_NE(out().find(" of CPU time: run --time-limit stops it"), std::string::npos) << out();
}

}  // namespace
}  // namespace superstep
