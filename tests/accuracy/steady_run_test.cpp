/// `run` where little or nothing is left to integrate.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bench/measure/run_one.hpp"
#include "bench/output/run_files.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

/// Six touching spheres in a row, a steady current of 1 V from end to end.
std::string write_row(const test::CaseFolder& folder, const std::string& more) {
  std::string rows = "id,x,y,z,radius\n";
  for (int k = 0; k < 6; ++k) rows += fmt::format("{},0,0,{},0.5\n", k, 0.95 * k);
  folder.write("row.csv", rows);
  return folder.write("row.toml",
                      "t_end = 1.0\nprobe = 3\n[packing]\nfile = \"row.csv\"\nlength_unit = "
                      "\"mm\"\n[material]\ndensity = 5000.0\n"
                      "[contact]\nneck = \"coble\"\n[electric]\nmode = \"steady\"\nconductivity = 1e5\nfixed "
                      "= [ { where = { ids = [5] "
                      "}, value = 1.0 }, { where = { ids = [0] }, value = 0.0 } ]\n" +
                          more);
}

RunResult run_with_probes(const Scene& scene, const std::string& spec) {
  const ProbeSet probes(scene);
  return run_one(scene, spec, {.probes = &probes});
}

nlohmann::json record(const Scene& scene, const std::string& spec, const RunResult& run,
                      std::span<const double> state) {
  const test::CaseFolder out;
  const ProbeSet probes(scene);
  return nlohmann::json::parse(
      write_run_files(out.file("."), scene, probes, run, state, record_run(scene, spec, run, state)));
}

TEST(SteadyRun, AFieldAloneIsSolvedForAndNothingIsIntegrated) {
  const test::CaseFolder folder;
  const Scene scene = load_scene(write_row(folder, ""));
  for (const char* spec : {"auto", "exponential", "cvode", "rkc", "forward-euler"}) {
    const RunResult run = run_with_probes(scene, spec);
    ASSERT_TRUE(run.outcome.ok()) << spec << ": " << run.outcome.reason;
    EXPECT_EQ(run.t_reached, 1.0);
    EXPECT_EQ(run.sweeps, 0U);
    EXPECT_EQ(record(scene, spec, run, scene.initial)["unknowns"], 0);
  }
  const std::string csv = final_csv(scene, 1.0, {});
  EXPECT_NE(csv.find("potential"), std::string::npos);
}

TEST(SteadyRun, RecordsWhatTheElectrodesDo) {
  const test::CaseFolder folder;
  const Scene scene =
      load_scene(write_row(folder, "[thermal]\nconductivity = 50.0\nspecific_heat = 500.0\n"));
  const RunResult run = run_with_probes(scene, "auto");
  ASSERT_TRUE(run.outcome.ok()) << run.outcome.reason;
  const auto json = record(scene, "auto", run, scene.initial);
  const double current = json["electrodes"]["current_in_a"], heat = json["electrodes"]["joule_heat_w"];
  EXPECT_GT(current, 0);
  EXPECT_NEAR(heat / current, 1.0, 1e-10);  // V I = heat, V = 1
  EXPECT_EQ(json["counts"]["potential_solves"],
            0);  // one solve when the scene was built, none while integrating
}

/// Hot ends conduct better than the start did, and the voltage has risen.
TEST(SteadyRun, TheElectrodesAreThoseOfTheEnd) {
  const test::CaseFolder folder;
  write_row(folder, "");
  std::string text = folder.read("row.toml");
  const auto put = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  put("value = 1.0 }", "value = { times = [0, 1], values = [0, 2] } }");
  put("conductivity = 1e5",
      "conductivity = { law = \"linear\", value = 1e5, coefficient = 0.01, reference = 300.0 }");
  const Scene scene = load_scene(folder.write(
      "hot.toml", text + "[thermal]\nconductivity = 50.0\nspecific_heat = 500.0\ninitial = 300.0\n"));
  RunResult run;
  run.t_reached = 1.0;
  std::vector<double> state = scene.initial;
  for (std::size_t k = 0; k < state.size(); ++k) state[k] += 20.0 * static_cast<double>(k);
  const auto electrodes = record_run(scene, "auto", run, state).electrodes;
  ASSERT_TRUE(electrodes);
  EXPECT_EQ(electrodes->voltage, 2.0);
  EXPECT_NEAR(electrodes->joule_heat / scene.rhs->inflow(1.0, state), 1, 1e-5)
      << "solved for anew where a conductivity has changed by 1e-6";
}

TEST(SteadyRun, ARefusalIsAnOutcomeOfAnyMethod) {
  const test::CaseFolder folder;
  const Scene scene = load_scene(write_row(
      folder,
      "[thermal]\nconductivity = { law = \"linear\", value = 50.0, coefficient = 0.1, reference = 0.0 "
      "}\nspecific_heat = 500.0\n"));
  const RunResult run = run_with_probes(scene, "exponential");
  EXPECT_EQ(run.outcome.status, Status::refused);
  EXPECT_EQ(record(scene, "exponential", run, scene.initial)["outcome"]["status"], "refused");
}

}  // namespace
}  // namespace superstep
