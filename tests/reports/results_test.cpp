#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "results/results_csv.hpp"
#include "results/results_json.hpp"
#include "results/results_table.hpp"
#include "results/text/csv_text.hpp"

namespace superstep {
namespace {

BenchRow measured_row() {
  BenchRow row;
  row.case_name = "rod";
  row.integrator = "sts";
  row.params = "n=5,nu=0.05";
  row.spec = "sts:n=5,nu=0.05";
  row.status = "ok";
  row.nodes = 20;
  row.contacts = 19;
  row.t_end = 1e-3;
  row.repetitions = 3;
  row.cpu_total = Timing{2, 1.5, 3};
  row.cpu_stepping = Timing{1, 0.9, 1.3};
  row.wall_stepping = Timing{1.25, 1, 2};
  row.speedup_total = 2;
  row.speedup_stepping = 4;
  row.steps = 7;
  row.rejected = 0;
  row.rhs = 35;
  row.jacobians = 0;
  row.factorizations = 0;
  row.solves = 0;
  row.max_stages = 5;
  row.peak_memory_mb = 12.5;
  row.errors.probe_mean = 1e-5;
  row.errors.rms = 1e-10;
  row.errors.max = std::numeric_limits<double>::quiet_NaN();
  row.errors.overshoot = 0;
  row.errors.reference_error = 2e-9;
  row.errors.published_mean = 2.5e-3;
  row.reference = "cvode:rtol=1e-9";
  return row;
}

BenchRow failed_row() {
  BenchRow row;
  row.case_name = "rod";
  row.integrator = row.spec = "forward-euler";
  row.status = "unstable";
  row.reason = "at t = 3 s the \"temperature\" grows, take a smaller step";
  row.t_end = 1e-3;
  return row;
}

BenchCase rod_case() {
  BenchCase one;
  one.name = "rod";
  one.title = "a rod";
  one.unit = "K";
  one.baseline = "forward-euler";
  one.t_end = 1e-3;
  one.reference = ReferenceFacts{"cvode:rtol=1e-9", true, 0};
  one.rows = {measured_row(), failed_row()};
  return one;
}

std::string line(const std::string& text, int number) {
  std::size_t begin = 0;
  for (int k = 0; k < number; ++k) begin = text.find('\n', begin) + 1;
  return text.substr(begin, text.find('\n', begin) - begin);
}

TEST(ResultsCsv, TheHeaderIsTheContract) {
  const BenchCase one = rod_case();
  EXPECT_EQ(
      line(results_csv({&one, 1}), 0),
      "case,integrator,params,status,reason,nodes,contacts,t_end,repetitions,threads,cpu_total_s,cpu_"
      "stepping_s,"
      "wall_stepping_s,speedup_total,speedup_stepping,speedup_theory,steps,rejected,rhs,jacobians,"
      "factorizations,"
      "solves,max_stages,peak_memory_mb,error_probe_mean,error_rms,error_max,error_relative_rms,"
      "overshoot,balance,"
      "decay_rate,decay_r2,reference,reference_error,error_as_published,decay_rate_as_published,"
      "decay_r2_as_published,span,delivered,distance_to_cvode,cpu_prepare_s,speedup_prepared,cpu_pilot_s,"
      "error_bound,cpu_verify_s,processes,instructions,rounding_bound");
}

TEST(ResultsCsv, NumbersArePlainAndWhatIsNotMeasuredIsEmpty) {
  const BenchCase one = rod_case();
  EXPECT_EQ(
      line(results_csv({&one, 1}), 1),
      "rod,sts,\"n=5,nu=0.05\",ok,,20,19,0.001,3,1,2,1,1.25,2,4,,7,0,35,0,0,0,5,12.5,1e-05,1e-10,,,0,,,,"
      "cvode:rtol=1e-9,2e-09,0.0025,,,,,,,,,,,1,,");
}

TEST(ResultsCsv, TextIsQuoted) {
  const BenchCase one = rod_case();
  EXPECT_EQ(line(results_csv({&one, 1}), 2),
            "rod,forward-euler,,unstable,\"at t = 3 s the \"\"temperature\"\" grows, take a smaller "
            "step\",0,0,0.001,0,1,"
            ",,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,1,,");
  EXPECT_EQ(csv_cell("two\nlines"), "\"two\nlines\"");
}

TEST(ResultsCsv, TwoFieldsAddTwinsAtTheEnd) {
  BenchCase one = rod_case();
  one.rows[0].potential = FieldErrors{};
  one.rows[0].potential->rms = 0.125;
  one.rows[0].potential->published_rate = 0.5;
  const std::string csv = results_csv({&one, 1});
  EXPECT_TRUE(line(csv, 0).ends_with(
      "decay_r2,reference,reference_error,error_probe_mean_potential,error_rms_potential,error_max_potential,"
      "error_relative_rms_potential,overshoot_potential,balance_potential,decay_rate_potential,decay_r2_"
      "potential,"
      "reference_error_potential,error_as_published,decay_rate_as_published,decay_r2_as_published,"
      "span,delivered,distance_to_cvode,error_as_published_potential,decay_rate_as_published_potential,"
      "decay_r2_as_published_potential,span_potential,delivered_potential,distance_to_cvode_potential,"
      "cpu_prepare_s,speedup_prepared,cpu_pilot_s,error_bound,cpu_verify_s,processes,instructions,rounding_"
      "bound"));
  EXPECT_TRUE(line(csv, 1).ends_with(",2e-09,,0.125,,,,,,,,0.0025,,,,,,,0.5,,,,,,,,,,1,,"));
}

TEST(ResultsJson, HoldsTheColumnsTheSpreadAndNulls) {
  BenchReport report;
  report.version = "1.2.3";
  report.machine = {{"processor", "a"}};
  report.cases = {rod_case()};
  const auto json = nlohmann::json::parse(results_json(report));
  EXPECT_EQ(json.at("schema"), "superstep.results");
  EXPECT_EQ(json.at("machine").at("processor"), "a");
  const auto& one = json.at("cases").at(0);
  EXPECT_EQ(one.at("reference_from_cache"), true);
  const auto& row = one.at("rows").at(0);
  EXPECT_EQ(row.at("cpu_stepping_s"), 1.0);
  EXPECT_EQ(row.at("spread").at("cpu_stepping_s").at("max"), 1.3);
  EXPECT_TRUE(row.at("error_max").is_null()) << "NaN is not a JSON number";
  EXPECT_TRUE(row.at("decay_rate").is_null());
  EXPECT_EQ(row.at("error_as_published"), 2.5e-3);
  EXPECT_TRUE(one.at("errors_as_published").is_null()) << "nothing is published about a rod";
  EXPECT_TRUE(one.at("cpu_joule_s").is_null());
  EXPECT_TRUE(one.at("rows").at(1).at("spread").at("cpu_stepping_s").is_null());
}

TEST(ResultsJson, SurvivesTextThatIsNotUtf8) {
  RunRecord record;
  record.reason = "caf\xe9";
  EXPECT_TRUE(nlohmann::json::accept(run_json(record)));
}

TEST(ResultsTable, ErrorsBelowTheReferencesBarAreShownAsTheBar) {
  const std::string text = results_table(rod_case(), 3, 1, false);
  EXPECT_NE(text.find("<2.0e-09"), std::string::npos) << text;
  EXPECT_NE(text.find("1.00e-05"), std::string::npos) << text;
  EXPECT_EQ(text.find("1.00e-10"), std::string::npos) << text;
}

TEST(ResultsTable, ReasonsStandBelow) {
  const std::string text = results_table(rod_case(), 3, 1, false);
  EXPECT_NE(text.find("\n  forward-euler: unstable: at t = 3 s"), std::string::npos) << text;
}

TEST(ResultsTable, FitsATerminalAndColoursChangeNoText) {
  const std::string plain = results_table(rod_case(), 3, 1, false);
  std::string colored = results_table(rod_case(), 3, 1, true);
  EXPECT_NE(colored, plain);
  for (std::size_t begin; (begin = colored.find('\033')) != std::string::npos;)
    colored.erase(begin, colored.find('m', begin) - begin + 1);
  // Blanks at line ends differ: a styled cell keeps them.
  std::erase(colored, ' ');
  std::string squeezed = plain;
  std::erase(squeezed, ' ');
  EXPECT_EQ(colored, squeezed);
}

}  // namespace
}  // namespace superstep
