/// Solutions that go through the end of a law, or run along it: every method ends, with the reason or with
/// the answer.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bench/measure/run_one.hpp"
#include "case/scene.hpp"
#include "integrators/registry.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

/// Ten spheres in a row from 300 K; the first is held at `hot`, the conductivity is a table up to `last`.
/// With a source in the middle the values rise beyond the held one.
Scene row(const test::TemporaryFolder& folder, double hot, double last, double source) {
  std::string packing = "id,x,y,z,radius\n";
  for (int k = 0; k < 10; ++k) packing += fmt::format("{},{},0,0,0.5\n", k, 0.98 * k);
  folder.write("row.csv", packing);
  return load_scene(folder.write(
      "case.toml",
      fmt::format(
          "t_end = 100.0\n[packing]\nfile = \"row.csv\"\nlength_unit = \"mm\"\n[material]\ndensity = 2500.0\n"
          "[contact]\nneck = \"hertz\"\n[thermal]\nspecific_heat = 500.0\ninitial = 300.0\n"
          "conductivity = {{ law = \"table\", temperatures = [300.0, {}], values = [50.0, 20.0] }}\n"
          "fixed = [ {{ where = {{ ids = [0] }}, value = {} }} ]\n"
          "source = [ {{ where = {{ ids = [5] }}, value = {} }} ]\n",
          last, hot, source)));
}

class AtTheEndOfALaw : public ::testing::TestWithParam<std::string> {};

std::vector<std::string> names() {
  std::vector<std::string> out;
  for (const auto& entry : integrators()) out.push_back(entry.name);
  return out;
}
INSTANTIATE_TEST_SUITE_P(Registry, AtTheEndOfALaw, ::testing::ValuesIn(names()), [](const auto& tested) {
  std::string name = tested.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST_P(AtTheEndOfALaw, ASolutionThatLeavesItIsAFailureThatNamesIt) {
  const test::TemporaryFolder folder;
  const Scene scene = row(folder, 400, 410, 1.0);  // the source alone would heat by thousands of kelvins
  const RunResult run = run_one(scene, GetParam(), {});
  if (run.outcome.status == Status::refused) return;  // of methods for constant conductivities
  EXPECT_EQ(run.outcome.status, Status::failed) << run.outcome.reason;
  EXPECT_NE(run.outcome.reason.find("410"), std::string::npos) << run.outcome.reason;
  EXPECT_NE(run.outcome.reason.find("clamp"), std::string::npos) << run.outcome.reason;
}

TEST_P(AtTheEndOfALaw, ASolutionThatRunsAlongItIsIntegrated) {
  const test::TemporaryFolder folder;
  const Scene scene =
      row(folder, 400, 400, 0.0);  // everything rises to the held value, the last of the table
  const RunResult run = run_one(scene, GetParam(), {});
  if (run.outcome.status == Status::refused) return;
  EXPECT_TRUE(run.outcome.ok()) << run.outcome.reason;
}

/// Ten spheres in a row that radiate, all of them free.
///   rest  of [thermal]
Scene radiating_row(const test::TemporaryFolder& folder, const std::string& rest) {
  std::string packing = "id,x,y,z,radius\n";
  for (int k = 0; k < 10; ++k) packing += fmt::format("{},{},0,0,0.5\n", k, 0.98 * k);
  folder.write("row.csv", packing);
  return load_scene(folder.write(
      "case.toml",
      "t_end = 5.0\n[packing]\nfile = \"row.csv\"\nlength_unit = \"mm\"\n[material]\ndensity = 2500.0\n"
      "[contact]\nneck = \"hertz\"\n[thermal]\nspecific_heat = 500.0\n" +
          rest));
}

TEST_P(AtTheEndOfALaw, ASinkThatTakesMoreThanThereIsEndsWhereRadiationHasNoMeaning) {
  const test::TemporaryFolder folder;
  // With a constant conductivity, and with a law: two right-hand sides.
  for (const char* conductivity :
       {"50.0", "{ law = \"linear\", value = 50.0, coefficient = -1e-6, reference = 300.0 }"}) {
    const Scene scene = radiating_row(
        folder, fmt::format("conductivity = {}\ninitial = 300.0\n"
                            "source = [ {{ where = {{ ids = [5] }}, value = -1.0 }} ]\n"
                            "radiation = [ {{ where = \"all\", emissivity = 0.8, ambient = 300.0 }} ]\n",
                            conductivity));
    const RunResult run = run_one(scene, GetParam(), {});
    if (run.outcome.status == Status::refused) return;
    EXPECT_EQ(run.outcome.status, Status::failed) << run.outcome.reason;
    EXPECT_NE(run.outcome.reason.find("radiation needs temperatures >= 0 K"), std::string::npos)
        << run.outcome.reason;
  }
}

/// Explicit methods pass below 0 K for a moment, by a little.
TEST_P(AtTheEndOfALaw, ColdBodiesThatRadiateAreIntegrated) {
  const test::TemporaryFolder folder;
  const Scene scene = radiating_row(
      folder,
      "conductivity = 50.0\ninitial = 0.0\nfixed = [ { where = { ids = [0] }, value = 900.0 } ]\n"
      "radiation = [ { where = \"all\", emissivity = 0.8, ambient = 0.0, kelvin = true } ]\n");
  const RunResult run = run_one(scene, GetParam(), {});
  if (run.outcome.status == Status::refused) return;
  EXPECT_TRUE(run.outcome.ok()) << run.outcome.reason;
}

/// Eighty million times the conductance within half a millikelvin: the step falls by as much at once, over
/// more trials than the seven after which ARKODE gives up by itself.
TEST(InsideALaw, AJumpIsPassedByArkode) {
  const test::TemporaryFolder folder;
  folder.write("pair.csv", "id,x,y,z,radius\n0,0,0,0,0.5\n1,0.98,0,0,0.5\n");
  const Scene scene = load_scene(folder.write(
      "case.toml",
      "t_end = 3000.0\n[packing]\nfile = \"pair.csv\"\nlength_unit = \"mm\"\n[material]\ndensity = 2500.0\n"
      "[contact]\nneck = \"hertz\"\n[thermal]\nspecific_heat = 500.0\ninitial = 300.0\n"
      "conductivity = { law = \"table\", temperatures = [300.0, 415.6, 415.6005, 600.0], values = [0.05, "
      "0.05, "
      "4e6, 4e6] }\n"
      "fixed = [ { where = { ids = [0] }, value = 530.0 } ]\n"));
  const RunResult run = run_one(scene, "arkode:rtol=1e-7", {});
  EXPECT_TRUE(run.outcome.ok()) << run.outcome.reason;
  EXPECT_GT(run.statistics.rejected, 7u);
}

}  // namespace
}  // namespace superstep
