#include "reports/gate/results_file.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "results/results_json.hpp"
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
