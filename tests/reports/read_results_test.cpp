
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "reports/gate/results_file.hpp"
#include "results/observations_csv.hpp"
#include "results/read_motion.hpp"
#include "results/results_json.hpp"
#include "results/study/read_work_precision.hpp"
#include "results/text/csv_table.hpp"
#include "results/text/csv_text.hpp"
#include "sample_report.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

using test::message_of;
using test::TemporaryFolder;

TEST(ReadResults, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  const BenchReport report = test::sample_report();
  const std::string text = results_json(report);
  EXPECT_EQ(results_json(read_results_json(folder.write("results.json", text))), text);
}

TEST(ReadResults, RunsToo) {
  const TemporaryFolder folder;
  const RunRecord record = test::sample_run();
  const std::string text = run_json(record);
  EXPECT_EQ(run_json(read_run_json(folder.write("run.json", text))), text);
}

TEST(ReadResults, NestingHasAnEnd) {
  const TemporaryFolder folder;
  const auto nested = [](std::size_t levels) {  // far deeper than a stack
    return std::string(levels, '[') + std::string(levels, ']');
  };
  for (const std::string key : {"machine", "cases", "unknown"}) {
    const std::string results = folder.write(
        "results.json", "{\"schema\": \"superstep.results\", \"" + key + "\": " + nested(1000000) + "}");
    EXPECT_NE(message_of<InputError>([&] { (void)read_results_json(results); }).find("nested deeper"),
              std::string::npos);
  }
  (void)folder.write("run.json", "{\"motion\": " + nested(1000000) + "}");
  EXPECT_NE(message_of<InputError>([&] { (void)read_motion(folder.file(".")); }).find("nested deeper"),
            std::string::npos);
}

TEST(ReadResults, RefusesWhatIsNotAResult) {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& content) {
    const std::string path = folder.write("results.json", content);
    return message_of<InputError>([&] { (void)read_results_json(path); });
  };
  EXPECT_NE(message("{").find("not JSON"), std::string::npos);
  EXPECT_NE(message("[]").find("schema"), std::string::npos);
  EXPECT_NE(message(R"({"schema": "superstep.run"})").find("superstep.results"), std::string::npos);
  EXPECT_NE(message(R"({"schema": "superstep.results", "schema_version": 99})").find("newer"),
            std::string::npos);
  EXPECT_NE(message(R"({"schema": "superstep.results", "schema_version": 1, "cases": [{"case": 5}]})")
                .find("results.json"),
            std::string::npos);
  EXPECT_EQ(message(R"({"schema": "superstep.results", "schema_version": 1, "future": 1})"), "");
}

/// Every reader of a results file names the version that it finds and the one that it takes.
TEST(ReadResults, RefusesAnotherVersion) {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> versions = {
      {R"(, "schema_version": 0)", "schema_version is 0"},
      {R"(, "schema_version": -1)", "schema_version is -1"},
      {R"(, "schema_version": 1.5)", "schema_version is 1.5"},
      {R"(, "schema_version": "1")", "schema_version is '\"1\"'"},
      {R"(, "schema_version": null)", "schema_version is 'null'"},
      {"", "schema_version is missing"}};
  const auto expect_refused = [&](const char* schema, const auto& read) {
    for (const auto& [version, said] : versions) {
      const std::string path =
          folder.write("file.json", fmt::format(R"({{"schema": "{}"{}}})", schema, version));
      const std::string message = message_of<InputError>([&] { read(path); });
      EXPECT_NE(message.find(said + ", and only version 1 of '" + schema + "' is read"), std::string::npos)
          << message;
    }
  };
  expect_refused("superstep.results", [](const std::string& path) { (void)read_results_json(path); });
  expect_refused("superstep.results", [](const std::string& path) { (void)read_results(path); });
  expect_refused("superstep.run", [](const std::string& path) { (void)read_run_json(path); });
}

TEST(ReadObservations, GiveBackWhatWasWritten) {
  const TemporaryFolder folder;
  const BenchReport report = test::sample_report();
  folder.write("histories.csv", histories_csv(report.cases));
  folder.write("snapshots.csv", snapshots_csv(report.cases));
  const auto seen = read_observations(folder.file("."));
  for (const auto& one : report.cases) {
    ASSERT_TRUE(seen.contains(one.name));
    BenchCase copy = one;
    copy.observations = seen.at(one.name);
    EXPECT_EQ(histories_csv({&copy, 1}), histories_csv({&one, 1}));
    EXPECT_EQ(snapshots_csv({&copy, 1}), snapshots_csv({&one, 1}));
  }
}

TEST(ReadObservations, RefuseWhatWasNeverSeen) {
  const TemporaryFolder folder;
  const std::string head = "case,spec,field,unit,probe,time,value,reference,in_transient\n";
  const auto refuses = [&](const std::string& rows) {
    folder.write("histories.csv", head + rows);
    return !message_of<InputError>([&] { (void)read_observations(folder.file(".")); }).empty();
  };
  const std::string row = "rod,rkc,temperature,K,7,";
  EXPECT_FALSE(refuses(row + "0,1,1,1\n" + row + "1,1,1,0\n"));
  EXPECT_TRUE(refuses(row + "-1,1,1,1\n")) << "before the start";
  EXPECT_TRUE(refuses(row + "2,1,1,1\n" + row + "1,1,1,1\n")) << "backwards";
  EXPECT_TRUE(refuses(row + "0,1,1,yes\n"));
}

TEST(ReadWorkPrecision, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  const WorkPrecision study = test::sample_study();
  const std::string text = work_precision_csv(study);
  const WorkPrecision read = read_work_precision_csv(folder.write("work_precision.csv", text));
  EXPECT_EQ(work_precision_csv(read), text);
  EXPECT_EQ(read.points[0].family, study.points[0].family);
  EXPECT_NEAR(read.span, 10, 1e-12);  // a quotient of two rounded numbers
}

/// Winners are found from what stands there: an error that is missing must not be 0, nor a time below it.
TEST(ReadWorkPrecision, RefusesWhatWasNeverMeasured) {
  const TemporaryFolder folder;
  const std::string good = work_precision_csv(test::sample_study());
  const auto with_cell = [&](std::size_t row, std::string_view column, const std::string& value) {
    const CsvTable table(folder.write("good.csv", good));
    std::string out;
    for (const auto& name : table.columns()) out += (out.empty() ? "" : ",") + csv_cell(name);
    out += "\n";
    for (std::size_t k = 0; k < table.rows(); ++k) {
      for (std::size_t c = 0; c < table.columns().size(); ++c)
        out +=
            (c > 0 ? "," : "") + csv_cell(k == row && c == table.column(column) ? value : table.text(k, c));
      out += "\n";
    }
    return out;
  };
  const auto refuses = [&](const std::string& text) {
    const auto file = folder.write("work_precision.csv", text);
    return !message_of<InputError>([&] { (void)read_work_precision_csv(file); }).empty();
  };
  ASSERT_TRUE(test::sample_study().points[0].ok());
  EXPECT_FALSE(refuses(with_cell(0, "reason", "none")));
  for (const char* column : {"cpu_s", "error_worst", "error_worst_relative"}) {
    EXPECT_TRUE(refuses(with_cell(0, column, ""))) << column;
    EXPECT_TRUE(refuses(with_cell(0, column, "-5"))) << column;
  }
  EXPECT_TRUE(refuses(with_cell(0, "error_worst", "0.0001"))) << "not the largest";
  for (const char* time : {"soon", "-1", "0.0001"}) {  // of the second output
    std::string text = good;
    EXPECT_TRUE(refuses(text.replace(text.find("_at_0.001") + 4, 5, time))) << time;
  }
  const auto without = [](std::string text, std::size_t columns) {  // of errors at the end
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', end + 1))
      for (std::size_t k = 0; k < columns; ++k) {
        const auto comma = text.rfind(',', end);
        text.erase(comma, end - comma);
        end = comma;
      }
    return text;
  };
  EXPECT_TRUE(refuses(without(good, 2))) << "no errors at all";
  EXPECT_TRUE(refuses(with_cell(0, "status", "okay")));
  EXPECT_TRUE(refuses(with_cell(1, "case", "another")));
  const auto first = good.find('\n') + 1;
  EXPECT_TRUE(refuses(good + good.substr(first, good.find('\n', first) + 1 - first))) << "a method twice";
}

}  // namespace
}  // namespace superstep
