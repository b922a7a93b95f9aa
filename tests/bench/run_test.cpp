#include <gtest/gtest.h>

#include <atomic>
#include <nlohmann/json.hpp>

#include "bench/app/loaded_case.hpp"
#include "bench/harness/run_check.hpp"
#include "bench/harness/work_precision.hpp"
#include "bench/measure/run_one.hpp"
#include "bench/output/run_files.hpp"
#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

using test::CaseFolder;
using test::Rod;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (LineReader reader(text); reader.next();) lines.emplace_back(reader.line());
  return lines;
}

class RodRun : public testing::Test {
 protected:
  RunResult run(const std::string& spec, const std::atomic<bool>* stop = nullptr) {
    RunRequest request{.probes = &probes_, .stop = stop};
    request.observe = [&](std::size_t, double t, std::span<const double> state) {
      times_.push_back(t);
      last_.assign(state.begin(), state.end());
    };
    return run_one(scene_, spec, request);
  }

  CaseFolder folder_;
  Scene scene_ = load_scene(write_rod(folder_, Rod{}));
  ProbeSet probes_{scene_};
  std::vector<double> times_, last_;
};

TEST_F(RodRun, VisitsEveryOutputTimeExactlyAndCountsItsWork) {
  const RunResult result = run("forward-euler:step=0.25");
  ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
  EXPECT_EQ(times_, scene_.output_times);
  EXPECT_EQ(result.statistics.steps, 400U);
  EXPECT_EQ(result.sweeps, 400U);
  EXPECT_EQ(result.t_reached, 100);
  EXPECT_EQ(result.history.size(), 401U) << "the initial state and every step end";
  EXPECT_EQ(result.history.time(0), 0);
}

TEST_F(RodRun, CountsOneRunAtATime) {
  (void)run("forward-euler:step=0.25");
  EXPECT_EQ(run("forward-euler:step=0.25").sweeps, 400U);
}

/// Whether a run finds its spans or is told them, it counts the same.
TEST(Pilot, IsNoPartOfARunsWork) {
  const Scene scene = load_scene(SUPERSTEP_SOURCE_DIR "/cases/lattice_two_way.toml");
  const RunResult finds = run_one(scene, "rkc:rtol=1e-3", {});
  ASSERT_TRUE(finds.outcome.ok()) << finds.outcome.reason;
  EXPECT_GT(finds.pilot_work.sweeps, 0U);
  const RunResult knows = run_one(scene, "rkc:rtol=1e-3", {.spans = finds.spans});
  EXPECT_EQ(knows.pilot_work.sweeps, 0U);
  EXPECT_EQ(finds.sweeps, knows.sweeps);
  EXPECT_EQ(finds.jacobians, knows.jacobians);
}

/// A run that is no more accurate says nothing of one.
TEST_F(RodRun, IsCheckedOnlyByWhatIsMoreAccurate) {
  const std::atomic<bool> stop{false};
  Progress silent(false);
  for (const auto& [spec, checked] : {std::pair("rkc:rtol=1e-6", true), {"rkc:rtol=1e-12", false}}) {
    std::vector<std::vector<double>> states;
    RunRequest request;
    request.observe = [&](std::size_t, double, std::span<const double> state) {
      states.emplace_back(state.begin(), state.end());
    };
    const RunResult result = run_one(scene_, spec, request);
    ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
    const RunCheck check = check_run(scene_, spec, result, states, stop, silent, {});
    EXPECT_EQ(check.outcome.ok(), checked) << spec << ": " << check.outcome.reason;
    EXPECT_EQ(check.delivered.empty(), !checked) << spec;
    RunRecord record;
    add_check(check, record);
    EXPECT_EQ(record.verified_by.empty(), !checked) << spec << ": a method that was not run";
  }
}

/// Where nothing happens, two methods differ by roundings, which are no part of a span.
TEST(ASceneAtRest, IsNotInaccurateByItsRoundings) {
  const CaseFolder folder;
  folder.write("row.csv", "id,x,y,z,r\n1,0,0,0,1e-3\n2,0,0,1.9e-3,1e-3\n3,0,0,3.8e-3,1e-3\n");
  const std::string whole = "t_end = 1.0\n[packing]\nfile = \"row.csv\"\n[contact]\nneck = \"hertz\"\n";
  const Scene scene = load_scene(folder.write(
      "case.toml", whole + "[material]\ndensity = 5000\n[thermal]\nspecific_heat = 500.0\ninitial = 300.0\n"
                           "conductivity = { law = \"linear\", value = 20.0, coefficient = 1e-4, "
                           "reference = 300.0 }\n"
                           "fixed = [ { where = { ids = [1] }, value = 300.0 } ]\n"));
  const std::atomic<bool> stop{false};
  Progress silent(false);
  const RunResult result = run_one(scene, "rkc:rtol=1e-3", {});
  ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
  const auto judged = [&](double off) {
    std::vector<double> state = scene.initial;
    for (double& value : state) value += off;
    const std::vector<std::vector<double>> states(scene.output_times.size(), state);
    const RunCheck check = check_run(scene, "rkc:rtol=1e-3", result, states, stop, silent, {});
    EXPECT_TRUE(check.outcome.ok()) << check.outcome.reason;
    return judge_check(scene, check);
  };
  EXPECT_TRUE(judged(1e-12).ok()) << judged(1e-12).reason;  // eighteen roundings of 300 K
  EXPECT_EQ(judged(1e-3).status, Status::inaccurate);
}

/// A steady potential alone is solved for as the case is read: no method has anything to do.
TEST(SteadyPotentialAlone, HasNoRunToCheckAndNoErrorToMeasureWorkAgainst) {
  const CaseFolder folder;
  folder.write("row.csv", "id,x,y,z,r\n1,0,0,0,1e-3\n2,0,0,1.9e-3,1e-3\n3,0,0,3.8e-3,1e-3\n");
  const auto load = [&] {
    return load_scene(folder.write("case.toml",
                                   "t_end = 1.0\n[packing]\nfile = \"row.csv\"\n[contact]\nneck = "
                                   "\"hertz\"\n[material]\ndensity = 5000\n"
                                   "[electric]\nmode = \"steady\"\nconductivity = 1e5\nfixed = [ { where = { "
                                   "ids = [1] }, value = 1.0 }, "
                                   "{ where = { ids = [3] }, value = 0.0 } ]\n"));
  };
  const Scene scene = load();
  const std::atomic<bool> stop{false};
  Progress silent(false);
  std::vector<std::vector<double>> states;
  RunRequest request;
  request.observe = [&](std::size_t, double, std::span<const double> state) {
    states.emplace_back(state.begin(), state.end());
  };
  const RunResult result = run_one(scene, "rkc", request);
  ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
  const RunCheck check = check_run(scene, "rkc", result, states, stop, silent, {});
  EXPECT_EQ(check.outcome.status, Status::refused);
  EXPECT_TRUE(judge_check(scene, check).ok());
  WorkPrecisionOptions options;
  options.use_cache = false;
  options.integrators = {"rkc"};
  EXPECT_THROW((void)work_precision(load(), options, silent), NumericalError);
}

TEST_F(RodRun, FailureIsAnOutcome) {
  EXPECT_EQ(run("forward-euler:step=0.7").outcome.status, Status::unstable);
  EXPECT_THROW((void)run("forward-euler:stepp=0.7"), UsageError);
}

TEST_F(RodRun, StopsWhenAsked) {
  const std::atomic<bool> stop{true};
  const RunResult result = run("forward-euler:step=0.25", &stop);
  EXPECT_EQ(result.outcome.status, Status::interrupted);
  EXPECT_LT(result.t_reached, 100);
}

TEST_F(RodRun, FinalCsvHoldsEveryNodeInTheUsersOrder) {
  (void)run("forward-euler");
  const auto lines = lines_of(final_csv(scene_, scene_.t_end, last_));
  ASSERT_EQ(lines.size(), 21U);
  EXPECT_EQ(lines[0], "id,temperature");
  EXPECT_EQ(lines[1], "1,0");
  EXPECT_EQ(lines[20], "20,10");
  EXPECT_TRUE(lines[10].starts_with("10,"));
}

TEST_F(RodRun, ProbesCsvRunsFromTheInitialStateToTheEnd) {
  for (const std::string spec : {"forward-euler:step=0.25", "cvode:rtol=1e-4"}) {
    SCOPED_TRACE(spec);
    const RunResult result = run(spec);
    const auto lines = lines_of(probes_csv(probes_, result.history, scene_.t_end));
    EXPECT_EQ(lines[0], "time,temperature_10");
    EXPECT_EQ(lines[1], "0,0");
    EXPECT_TRUE(lines.back().starts_with("100,")) << lines.back();
  }
}

TEST_F(RodRun, ANumberInTheCsvReadsBackAsItself) {
  const RunResult result = run("forward-euler:step=0.25");
  const auto lines = lines_of(probes_csv(probes_, result.history, scene_.t_end));
  const std::string cell = lines.back().substr(lines.back().find(',') + 1);
  EXPECT_EQ(std::stod(cell), result.history.value(result.history.size() - 1, 0));
}

TEST(ProbesCsv, AProbeOnAFixedNodeIsConstant) {
  const CaseFolder folder;
  Rod rod;
  rod.head = "t_end = 10\nprobe = [20, 2]\n";
  const Scene scene = load_scene(write_rod(folder, rod));
  const ProbeSet probes(scene);
  const RunResult result = run_one(scene, "forward-euler", {.probes = &probes});
  const auto lines = lines_of(probes_csv(probes, result.history, scene.t_end));
  EXPECT_EQ(lines[0], "time,temperature_20,temperature_2");
  EXPECT_TRUE(lines[1].starts_with("0,10,0"));
  EXPECT_TRUE(lines.back().starts_with("10,10,"));
}

TEST_F(RodRun, WritesItsFilesAndRemovesStaleOnes) {
  const std::string out = folder_.file("out");
  const RunResult good = run("forward-euler");
  write_run_files(out, scene_, probes_, good, last_, record_run(scene_, "forward-euler", good, last_));
  EXPECT_TRUE(folder_.has("out/final.csv") && folder_.has("out/probes.csv") && folder_.has("out/run.json"));
  const auto json = nlohmann::json::parse(folder_.read("out/run.json"));
  EXPECT_EQ(json.at("outcome").at("status"), "ok");
  EXPECT_EQ(json.at("counts").at("steps"), good.statistics.steps);
  EXPECT_EQ(json.at("files"), (std::vector<std::string>{"final.csv", "probes.csv", "run.json"}));

  const RunResult bad = run("forward-euler:step=0.7");
  write_run_files(out, scene_, probes_, bad, last_, record_run(scene_, "forward-euler:step=0.7", bad, last_));
  EXPECT_FALSE(folder_.has("out/final.csv") || folder_.has("out/probes.csv"));
  EXPECT_EQ(nlohmann::json::parse(folder_.read("out/run.json")).at("outcome").at("status"), "unstable");
}

TEST(LoadedCase, ABadSpecInACaseIsTheFilesFault) {
  const CaseFolder folder;
  Rod rod;
  rod.bench = "integrators = [\"forward-euler:stepp=1\"]\n";
  const std::string file = write_rod(folder, rod);
  try {
    (void)load_checked_case(file);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(file), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("'step'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace superstep
