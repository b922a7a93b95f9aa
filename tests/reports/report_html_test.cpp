/// The report as a whole: complete without scripts, harmless whatever the names, sensible whatever is
/// missing.

#include "reports/html/report_html.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "checked_report.hpp"
#include "core/error.hpp"
#include "reports/html/published.hpp"
#include "results/observations_csv.hpp"
#include "results/results_json.hpp"
#include "sample_report.hpp"
#include "support/markup.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

using test::MarkupReader;
using test::message_of;
using test::report_of;
using test::TemporaryFolder;

void write_benchmark(const TemporaryFolder& folder, const BenchReport& report) {
  folder.write("results.json", results_json(report));
  folder.write("histories.csv", histories_csv(report.cases));
  folder.write("snapshots.csv", snapshots_csv(report.cases));
}

bool has(const std::string& html, const std::string& part) {
  return html.find(part) != std::string::npos;
}

TEST(Report, HoldsEverySectionOfACompleteBenchmark) {
  const TemporaryFolder folder;
  write_benchmark(folder, test::sample_report());
  folder.write("work_precision.csv", work_precision_csv(test::sample_study()));
  folder.write(
      "stability_rounding.csv",
      "n,nu,order,internal_amplification,superstep_rounding_eps,run_rounding_spans,run_error_spans,right\n"
      "5,0.05,leja,1,1,1e-15,1e-7,yes\n20,0.05,leja,1,1,1e+20,1e-7,no\n");
  const std::string html = report_of(folder);
  for (const char* id : {"case-1-answer", "case-1-case", "case-1-results", "case-1-speed",
                         "case-1-work-precision", "case-1-probes", "case-1-errors", "case-1-sts",
                         "case-1-paper", "case-1-skipped", "stability", "machine"}) {
    EXPECT_TRUE(has(html, std::string("<section id=\"") + id + "\"")) << id;
    EXPECT_TRUE(has(html, std::string("href=\"#") + id + "\"")) << id << " in the contents";
  }
  for (const char* id :
       {"case-1-theory-stepping only", "case-1-substeps-10", "case-1-cumulative-20", "case-1-gain",
        "case-1-packing-temperature", "case-1-cpu", "case-1-paper-speedup", "stability-rounding-0"})
    EXPECT_TRUE(has(html, std::string("id=\"") + id + "\"")) << id;
  EXPECT_TRUE(has(html, "✗ 10²⁰")) << "lost digits are crossed out, not only coloured";
}

TEST(Report, OfFailuresOnlySaysWhy) {
  const TemporaryFolder folder;
  BenchReport report = test::sample_report();
  auto& one = report.cases[0];
  one.rows = {one.rows.back()};
  one.rows[0].reason = "errors grow; take a smaller step";
  one.observations = {};
  write_benchmark(folder, report);
  const std::string html = report_of(folder);
  EXPECT_TRUE(has(html, "0 of 1 run succeeded"));
  EXPECT_TRUE(has(html, "errors grow; take a smaller step"));
  EXPECT_FALSE(has(html, "id=\"case-1-speed\""));
}

TEST(Report, OfOneMethodOnly) {
  const TemporaryFolder folder;
  BenchReport report = test::sample_report();
  report.cases[0].rows.resize(1);
  report.cases[0].observations.curves.resize(1);
  write_benchmark(folder, report);
  const std::string html = report_of(folder);
  EXPECT_TRUE(has(html, "1 of 1 run succeeded"));
  EXPECT_FALSE(has(html, "id=\"case-1-sts\"")) << "no super-time-stepping was run";
}

TEST(Report, WithoutAReferenceHasHistoriesAndNoErrors) {
  const TemporaryFolder folder;
  BenchReport report = test::sample_report();
  auto& one = report.cases[0];
  one.reference.reset();
  for (auto& row : one.rows) {
    row.errors = {};
    row.reference.clear();
  }
  for (auto& curve : one.observations.curves) {
    curve.reference.clear();
    curve.transient = 0;
  }
  write_benchmark(folder, report);
  const std::string html = report_of(folder);
  EXPECT_TRUE(has(html, "No reference: how accurate the methods are was not measured"));
  EXPECT_TRUE(has(html, "id=\"case-1-probes\""));
  EXPECT_FALSE(has(html, "id=\"case-1-errors\""));
}

TEST(Report, OfAnEmptyBenchmark) {
  const TemporaryFolder folder;
  BenchReport report;
  report.interrupted = true;
  write_benchmark(folder, report);
  EXPECT_TRUE(has(report_of(folder), "was interrupted"));
}

TEST(Report, OfTwoFieldsShowsBoth) {
  const TemporaryFolder folder;
  BenchReport report = test::sample_report();
  auto& one = report.cases[0];
  one.source = "Rojek & Nisar 2026, section 9.2";
  for (auto& row : one.rows)
    if (row.ok()) row.potential = row.errors;
  auto potential = one.observations.curves;
  for (auto& curve : potential) {
    curve.field = "potential";
    curve.unit = "V";
  }
  auto& curves = one.observations.curves;
  curves.insert(curves.end(), potential.begin(), potential.end());
  write_benchmark(folder, report);
  const std::string html = report_of(folder);
  EXPECT_TRUE(has(html, "potential: rms error [V]"));
  EXPECT_TRUE(has(html, "potential [V]"));
  EXPECT_TRUE(has(html, "Error at the probe (table 3)"));
}

TEST(Report, OfRunsAlone) {
  const TemporaryFolder folder;
  folder.write("run.json", run_json(test::sample_run()));
  folder.write("probes.csv", "time,temperature_mid-height\n0,0\n0.001,5\n");
  folder.write("final.csv",
               "id,x,y,z,r,temperature\n1,0,0,0,1,0\n2,0,0,2,1,10\n3,3,1.9,0,1,5\n4,3,-1.9,0,1,5\n");
  const std::string html = report_of(folder);
  EXPECT_TRUE(has(html, "id=\"runs-probe-1\""));
  EXPECT_TRUE(has(html, "id=\"runs-packing-temperature\""));
  const auto picture = html.find("id=\"runs-packing-temperature\"");
  EXPECT_EQ(MarkupReader(html).problem(), "");
  EXPECT_EQ(html.find("<circle", html.find("<circle", html.find("<circle", picture) + 1) + 1),
            std::string::npos)
      << "two of four spheres reach the mid-plane";
}

TEST(Report, OfAMillionParticlesStaysSmall) {
  const TemporaryFolder folder;
  folder.write("run.json", run_json(test::sample_run()));
  std::string final_csv = "id,x,y,z,r,temperature\n";
  constexpr int side = 100;
  for (int k = 0; k < side * side * side; ++k)
    final_csv += std::to_string(k) + "," + std::to_string(k % side) + "," + std::to_string(k / side % side) +
                 "," + std::to_string(k / side / side) + ",0.51,1.5\n";
  folder.write("final.csv", final_csv);
  const std::string html = report_of(folder);
  EXPECT_LT(html.size(), 10'000'000U);
  EXPECT_TRUE(has(html, " such spheres 4000, chosen at random")) << "and says so";
}

TEST(Report, NeedsResults) {
  const TemporaryFolder folder;
  EXPECT_NE(
      message_of<InputError>([&] { (void)read_report_input(folder.file(".")); }).find("superstep bench"),
      std::string::npos);
  EXPECT_NE(
      message_of<InputError>([&] { (void)read_report_input(folder.file("missing")); }).find("not a folder"),
      std::string::npos);
  folder.write("results.json", "{}");
  EXPECT_NE(message_of<InputError>([&] { (void)read_report_input(folder.file(".")); }).find("schema"),
            std::string::npos);
}

TEST(Report, RefusesFilesOfTwoBenchmarks) {
  const TemporaryFolder folder;
  BenchReport report = test::sample_report();
  const auto message = [&] {
    return message_of<InputError>([&] { (void)read_report_input(folder.file(".")); });
  };
  folder.write("results.json", results_json(report));
  WorkPrecision study = test::sample_study();
  folder.write("work_precision.csv", work_precision_csv(study));
  folder.write("histories.csv", histories_csv(report.cases));
  EXPECT_EQ(message(), "");
  report.cases[0].name = "another";
  folder.write("histories.csv", histories_csv(report.cases));
  EXPECT_TRUE(has(message(), "speaks of case 'another'")) << message();
  folder.write("histories.csv", "case,spec,field,unit,probe,time,value,reference,in_transient\n");
  study.output_times.pop_back();  // as where the last column is cut off
  for (auto& point : study.points) point.error_rms.resize(point.error_rms.empty() ? 0 : 1);
  folder.write("work_precision.csv", work_precision_csv(study));
  EXPECT_TRUE(has(message(), "output times")) << message();
}

TEST(Published, TablesOfThePaperAreComplete) {
  const auto thermal = published_case("Rojek & Nisar 2026, section 9.1");
  ASSERT_TRUE(thermal);
  std::size_t errors = 0, speedups = 0;
  for (const auto& run : thermal->runs) {
    errors += run.error_mean ? 1 : 0;
    speedups += run.speedup_stepping ? 1 : 0;
    // A published speedup is the quotient of two published times, all rounded to four digits or fewer.
    if (run.cpu_stepping) {
      EXPECT_NEAR(*thermal->runs[0].cpu_stepping / *run.cpu_stepping, *run.speedup_stepping, 0.6);
    }
  }
  EXPECT_EQ(errors, 12U);
  EXPECT_EQ(speedups, 16U);
  EXPECT_EQ(published_case("Rojek & Nisar 2026, section 9.2")->runs.size(), 13U);
  EXPECT_FALSE(published_case("somebody else"));
}

}  // namespace
}  // namespace superstep
