/// superstep bench --press-table: its rows are those of runs of the same presses, one by one.

#include "bench/press/press_table.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bench/app/cli/run_program.hpp"
#include "bench/host/progress.hpp"
#include "case/press/press.hpp"
#include "core/error.hpp"
#include "dynamics/volume_fraction.hpp"
#include "integrators/press/motion.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

/// Thirty warm particles: poured to 0.02 s, pressed to `wall`, held for `hold` seconds, released.
std::string press_text(double wall, double hold, int seed, const std::string& more = "") {
  return fmt::format(R"(t_end = {2}
[material]
density = 2000.0
[thermal]
conductivity = 1e3
specific_heat = 100.0
initial = 600.0
walls = 700.0
[dynamics]
gravity = 9.81
drag = 0.1
[dynamics.box]
min = [0.0, 0.0, 0.0]
max = [0.4, 0.4, 0.4]
[dynamics.particles]
count = 30
radius = 0.05
seed = {4}
[dynamics.contact]
stiffness = 1e7
damping = 0.3
[dynamics.wall]
stiffness = 1e7
damping = 0.3
[[dynamics.phases]]
name = "pour"
until = 0.02
[[dynamics.phases]]
name = "press"
until = 0.05
upper_wall = {0}
[[dynamics.phases]]
name = "hold"
until = {1}
[[dynamics.phases]]
name = "release"
until = {2}
upper_wall = 0.35
[bench]
baseline = "forward-euler"
{3})",
                     wall, 0.05 + hold, 0.05 + hold + 0.03, more, seed);
}

const char* const table =
    "[bench.press_table]\nhold = [0.02, 0.01]\nupper_wall = [0.14, 0.12]\nseeds = [1, 3]\n";

TEST(PressTables, RowsAreThoseOfRunsOneByOne) {
  const test::CaseFolder folder;
  Progress progress(false);
  const Press one = load_press(folder.write("press.toml", press_text(0.12, 0.02, 1, table)));
  const auto rows = press_table(one, nullptr, progress);
  ASSERT_EQ(rows.size(), 8u);
  for (const auto& row : rows) {
    ASSERT_TRUE(row.ok()) << row.reason;
    const Press alone = load_press(
        folder.write("alone.toml", press_text(row.upper_wall, row.hold, static_cast<int>(row.seed))));
    dynamics::Motion motion(alone.model, alone.particles, alone.stepping);
    motion.start(alone.state);
    const auto fraction_at = [&](double t) {
      EXPECT_TRUE(motion.advance(t).ok());
      return dynamics::volume_fraction(alone.model.box, row.upper_wall, motion.state().position,
                                       alone.particles.radius);
    };
    // Steps of the longest hold end elsewhere: both are as far from the truth as the tolerance lets them be.
    constexpr double close = 2e-3;
    EXPECT_NEAR(*row.poured, fraction_at(0.02), 1e-12) << row.upper_wall << " " << row.hold;
    EXPECT_NEAR(*row.pressed, fraction_at(0.05 + row.hold), close) << row.upper_wall << " " << row.hold;
    EXPECT_NEAR(*row.released, fraction_at(alone.t_end), close) << row.upper_wall << " " << row.hold;
    EXPECT_GT(*row.springback(), 10 * close) << "there is something to agree on";
  }
}

TEST(PressTables, SeveralCasesStandInOneTable) {
  const test::CaseFolder folder;
  const std::string first = folder.write("first.toml", press_text(0.12, 0.02, 1, table)),
                    second = folder.write("second.toml", press_text(0.12, 0.02, 2, table));
  testing::internal::CaptureStdout();
  ASSERT_EQ(run_program({"bench", first, second, "--press-table", "--json", "--report", "--quiet", "--out",
                         folder.file("out")}),
            0);
  const auto json = nlohmann::json::parse(testing::internal::GetCapturedStdout());
  ASSERT_EQ(json["rows"].size(), 16u);
  EXPECT_EQ(json["rows"][0]["case"], "first");
  EXPECT_EQ(json["rows"][15]["case"], "second");
  EXPECT_EQ(read_press_table_csv(folder.file("out/press_table.csv")).size(), 16u);
  const std::string page = folder.read("out/report.html");
  EXPECT_NE(page.find("Springback: first"), std::string::npos);
  EXPECT_NE(page.find("Springback: second"), std::string::npos);
}

TEST(PressTables, StopWhenTheyAreToldTo) {
  const test::CaseFolder folder;
  Progress progress(false);
  const std::atomic<bool> stop = true;
  const Press one = load_press(folder.write("press.toml", press_text(0.12, 0.02, 1, table)));
  EXPECT_TRUE(press_table(one, &stop, progress).empty());
}

TEST(PressTables, SayWhatTheyLack) {
  const test::CaseFolder folder;
  Progress progress(false);
  const auto refusal = [&](const std::string& text) {
    const Press one = load_press(folder.write("press.toml", text));
    return test::message_of<InputError>([&] { (void)press_table(one, nullptr, progress); });
  };
  EXPECT_NE(refusal(press_text(0.2, 0.02, 1)).find("has no [bench.press_table]"), std::string::npos);
  EXPECT_NE(refusal(press_text(0.2, 0.02, 1,
                               "[bench.press_table]\nhold = [0.01]\nupper_wall = [0.5]\nseeds = [1]\n"))
                .find("upper_wall has 0.5 m"),
            std::string::npos);
}

TEST(PressTables, OnlyGeneratedParticlesHaveSeeds) {
  const test::CaseFolder folder;
  Progress progress(false);
  const std::string generated = "count = 30\nradius = 0.05\nseed = 1\n";
  const auto listed = [&](const std::string& table_of_press) {
    std::string text = press_text(0.12, 0.01, 1, table_of_press);
    return text.replace(text.find(generated), generated.size(),
                        "list = [ { position = [0.2, 0.2, 0.05], radius = 0.05 },\n"
                        "         { position = [0.2, 0.2, 0.15], radius = 0.05 } ]\n");
  };
  const std::string axes = "[bench.press_table]\nhold = [0.01]\nupper_wall = [0.15]\n";
  const auto rows = press_table(load_press(folder.write("listed.toml", listed(axes))), nullptr, progress);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_TRUE(rows[0].ok()) << rows[0].reason;
  EXPECT_EQ(rows[0].seed, 0u);
  const std::string refused = folder.write("seeds.toml", listed(axes + "seeds = [1]\n"));
  EXPECT_NE(test::message_of<InputError>([&] { (void)load_press(refused); }).find("only generated particles"),
            std::string::npos);
}

}  // namespace
}  // namespace superstep
