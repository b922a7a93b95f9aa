#include "reports/gate/results_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "integrators/integrator.hpp"
#include "results/results_json.hpp"
#include "results/schema/bench_fields.hpp"
#include "sample_report.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

TEST(ResultsFile, ReadsBackWhatBenchWrites) {
  BenchRow row;
  row.case_name = "rod";
  row.integrator = "sts";
  row.params = "n=5,nu=0.05";
  row.spec = "sts:n=5,nu=0.05";
  row.status = "ok";
  row.steps = 7;
  row.errors.rms = 1e-4;
  row.cpu_stepping_samples = {0.5, 0.25};
  row.yardstick_samples = {0.125, 0.0625};
  BenchCase one;
  one.name = "rod";
  one.baseline = "sts:n=5,nu=0.05";
  one.rows = {row};
  const BenchReport report{.version = "1",
                           .revision = "abc",
                           .machine = {{"processor", "p"}, {"flags", "-O3"}},
                           .libraries = {},
                           .repetitions = 2,
                           .threads = 2,
                           .interrupted = false,
                           .cases = {one}};
  const test::TemporaryFolder folder;
  folder.write("results.json", results_json(report));
  const auto file = read_results(folder.file(""));
  EXPECT_EQ(file.processor, "p");
  EXPECT_EQ(file.threads, 2);
  const auto* read = file.find("rod")->find("sts:n=5,nu=0.05");
  ASSERT_NE(read, nullptr);
  EXPECT_EQ(read->number("steps"), 7);
  EXPECT_EQ(read->number("error_rms"), 1e-4);
  EXPECT_FALSE(read->number("error_max").has_value());
  EXPECT_EQ(relative_timings(*file.find("rod"), *read).yardstick, row.yardstick_samples);
}

TEST(ResultsFile, LeavesOutWhatTheInterruptCameBefore) {
  BenchRow reached, not_reached;
  reached.integrator = reached.spec = "rkc";
  not_reached.integrator = not_reached.spec = "rkl";
  reached.status = not_reached.status = "ok";
  reached.steps = 7;
  BenchCase one;
  one.name = "rod";
  one.baseline = "rkc";
  one.rows = {reached, not_reached};
  BenchReport report;
  report.cases = {one};
  const test::TemporaryFolder folder;
  const auto path = folder.write("results.json", results_json(report));
  EXPECT_THROW((void)read_results(path), InputError);
  report.interrupted = true;
  folder.write("results.json", results_json(report));
  const auto file = read_results(path);
  EXPECT_TRUE(file.interrupted);
  EXPECT_EQ(file.cases[0].rows.size(), 1U);
}

/// What the program writes is what its readers know.
TEST(ResultsFile, KnowsTheStatusOfEveryOutcome) {
  std::vector<std::string> names;
  for (int k = 0; k <= static_cast<int>(Status::interrupted); ++k)
    names.emplace_back(status_name(static_cast<Status>(k)));
  EXPECT_EQ(statuses(), names);
}

/// What a comparison, the gate and the report go by: none of them judges a file that no benchmark wrote.
TEST(ResultsFile, RefusesWhatWasNeverMeasured) {
  using Json = nlohmann::ordered_json;
  const test::TemporaryFolder folder;
  const std::string good = results_json(test::sample_report());
  const auto path = folder.write("results.json", good);
  EXPECT_NO_THROW((void)read_results(path));
  EXPECT_NO_THROW((void)read_results_json(path));
  const auto expect_refused = [&](const std::string& key, const auto& garble) {
    Json json = Json::parse(good);
    garble(json["cases"][0]);
    folder.write("results.json", json.dump());
    const auto by_gate = test::message_of<InputError>([&] { (void)read_results(path); });
    const auto by_report = test::message_of<InputError>([&] { (void)read_results_json(path); });
    EXPECT_NE(by_gate.find("key 'cases[0]." + key), std::string::npos) << by_gate;
    EXPECT_EQ(by_report, by_gate);
  };
  const auto in_row = [&](const char* key, const Json& value) {
    expect_refused(fmt::format("rows[0].{}'", key), [&](Json& one) { one["rows"][0][key] = value; });
  };
  for (const char* counter : {"steps", "rejected", "rhs", "solves", "nodes", "max_stages", "instructions"}) {
    in_row(counter, -5);
    in_row(counter, 1.5);
    in_row(counter, 1e300);
  }
  for (const char* amount : {"error_rms", "error_max_potential", "reference_error", "span",
                             "speedup_stepping", "cpu_prepare_s", "peak_memory_mb", "t_end"})
    in_row(amount, -1e-3);
  in_row("cpu_stepping_samples_s", {0.25, -0.25});
  for (const Json& status : {Json("okay"), Json(""), Json()}) in_row("status", status);
  in_row("spec", "exponential:rtol=9");
  in_row("case", "another");
  expect_refused("output_times'", [](Json& one) { one["output_times"] = {-1.0, 1.0}; });
  expect_refused("rows[0].spread.cpu_stepping_s.min'",
                 [](Json& one) { one["rows"][0]["spread"]["cpu_stepping_s"]["min"] = -1; });
  expect_refused("rows[", [](Json& one) {
    one["rows"].push_back(one["rows"][0]);
    one["rows"].back()["steps"] = 1;
  });
  Json twice = Json::parse(good);
  twice["cases"].push_back(twice["cases"][0]);
  folder.write("results.json", twice.dump());
  EXPECT_THROW((void)read_results(path), InputError);
  EXPECT_THROW((void)read_results_json(path), InputError);
}

TEST(ResultsFile, RefusesWhatIsNoResult) {
  const test::TemporaryFolder folder;
  for (const char* text :
       {"{", "[]", R"({"schema": "superstep.run", "schema_version": 1})", "{\"schema\": 3}"}) {
    const auto path = folder.write("results.json", text);
    EXPECT_NE(test::message_of<InputError>([&] { (void)read_results(path); }).find(path), std::string::npos)
        << text;
  }
  EXPECT_THROW((void)read_results(folder.file("absent.json")), InputError);
}

}  // namespace
}  // namespace superstep
