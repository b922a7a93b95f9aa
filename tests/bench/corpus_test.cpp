/// bench --corpus: measures what is there, keeps what failed, and does not measure twice.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "bench/app/cli/run_program.hpp"
#include "results/corpus/corpus_csv.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

namespace fs = std::filesystem;

class CorpusRun : public testing::Test {
 protected:
  test::CaseFolder folder_;

  void SetUp() override {
    fs::create_directory(folder_.file("cases"));
    write_case("rod", "size = 30");
    write_case("bar", "size = 40");
  }
  void write_case(const std::string& name, const std::string& size, const std::string& more = "") {
    folder_.write(
        "cases/" + name + ".toml",
        fmt::format("t_end = 50\n{}\n[network]\ngenerator = \"ladder\"\n{}\ninlet = 1\n", more, size));
  }
  int bench(std::vector<std::string> more) {
    std::vector<std::string> line = {"bench",   "--corpus", folder_.file("cases"),
                                     "--quiet", "--out",    folder_.file("out")};
    line.insert(line.end(), more.begin(), more.end());
    testing::internal::CaptureStdout();
    const int code = run_program(line);
    out_ = testing::internal::GetCapturedStdout();
    return code;
  }
  [[nodiscard]] std::vector<CorpusRow> rows() const {
    return read_corpus_csv(folder_.file("out/corpus.csv"));
  }
  std::string out_;
};

TEST_F(CorpusRun, MeasuresEverySceneWithEveryMethod) {
  ASSERT_EQ(bench({"--integrator", "rkc:rtol=1e-3", "auto:rtol=1e-3", "forward-euler"}), 0);
  const auto all = rows();
  // forward-euler stands for its ladder of four.
  EXPECT_EQ(all.size(), 2u * 6u);
  for (const auto& row : all) {
    if (row.spec == "forward-euler:alpha=1") {  // no bound of the stable step, and its row stays
      EXPECT_EQ(row.status, "unstable") << row.reason;
      continue;
    }
    EXPECT_EQ(row.status, "ok") << row.spec << ": " << row.reason;
    EXPECT_GT(row.cpu.value_or(0), 0);
    EXPECT_TRUE(row.cpu_prepare.has_value()) << row.spec;
    EXPECT_LT(row.error.value_or(1), 0.1);
  }
  for (const char* said : {"Which method for which scenes", "The fastest method of every scene",
                           "What auto costs beside the best method"})
    EXPECT_NE(out_.find(said), std::string::npos) << said;
}

TEST_F(CorpusRun, CompareNamesScenesThatStandInOneOfTwoOnly) {
  ASSERT_EQ(bench({"--integrator", "rkc", "--repetitions", "1"}), 0);
  auto some = rows();
  std::erase_if(some, [](const CorpusRow& row) { return row.scene == "rod"; });
  folder_.write("some.csv", corpus_csv(some));
  testing::internal::CaptureStdout();
  (void)run_program({"compare", folder_.file("out/corpus.csv"), folder_.file("some.csv")});
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_NE(text.find("only in A: rod\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("only in B"), std::string::npos) << text;
}

TEST_F(CorpusRun, DoesNotMeasureAgainWhatItHas) {
  ASSERT_EQ(bench({"--integrator", "rkc:rtol=1e-3"}), 0);
  const std::string first = folder_.read("out/corpus.csv");
  ASSERT_EQ(bench({"--integrator", "rkc:rtol=1e-3"}), 0);
  EXPECT_EQ(folder_.read("out/corpus.csv"), first);  // times to the last digit
  ASSERT_EQ(bench({"--integrator", "rkc:rtol=1e-3", "rock:rtol=1e-3"}), 0);
  const auto all = rows();
  ASSERT_EQ(all.size(), 4u);
  const std::string now = folder_.read("out/corpus.csv");
  for (std::size_t begin = 0; begin < first.size();) {
    const std::size_t end = first.find('\n', begin);
    EXPECT_NE(now.find(first.substr(begin, end - begin)), std::string::npos);
    begin = end + 1;
  }
}

TEST_F(CorpusRun, KeepsWhatIsNotAskedForThisTime) {
  ASSERT_EQ(bench({"--integrator", "rkc:rtol=1e-3", "rock:rtol=1e-3"}), 0);
  ASSERT_EQ(bench({"--integrator", "rkc:rtol=1e-3"}), 0);
  EXPECT_EQ(out_.find("rock"), std::string::npos) << out_;
  EXPECT_EQ(rows().size(), 4u) << "hours of measuring are not lost by a look at one method";
  write_case("rod", "size = 30\nspread = 3");
  ASSERT_EQ(bench({"--integrator", "rkc:rtol=1e-3"}), 0);
  EXPECT_EQ(rows().size(), 3u) << "what was measured on another rod is gone";
}

TEST_F(CorpusRun, MeasuresAgainWhatHasChanged) {
  ASSERT_EQ(bench({"--integrator", "rkc:rtol=1e-3"}), 0);
  const auto before = rows();
  write_case("rod", "size = 30\nspread = 3");
  ASSERT_EQ(bench({"--integrator", "rkc:rtol=1e-3"}), 0);
  const auto after = rows();
  for (std::size_t k = 0; k < before.size(); ++k)
    EXPECT_EQ(before[k].key == after[k].key, before[k].scene == "bar") << before[k].scene;
}

TEST_F(CorpusRun, AStepOfALadderThatIsGivenToo) {
  ASSERT_EQ(bench({"--integrator", "forward-euler", "forward-euler:alpha=1", "--repetitions", "1"}), 0);
  EXPECT_EQ(rows().size(), 2u * 4u) << "its readers refuse a method that stands twice";
}

TEST_F(CorpusRun, KeepsWhatFailed) {
  write_case("stiff", "size = 2000\ncontrast = 1e9");
  ASSERT_EQ(
      bench({"--integrator", "rkc:rtol=1e-2", "rkc:rtol=1e-4", "cvode:rtol=1e-4", "--time-limit", "0.05"}),
      0);
  std::size_t late = 0;
  for (const auto& row : rows())
    if (row.scene == "stiff" && row.integrator == "rkc") {
      EXPECT_EQ(row.status, "timeout");
      EXPECT_FALSE(row.cpu);
      EXPECT_FALSE(row.reason.empty());
      ++late;
    }
  EXPECT_EQ(late, 2u);
  EXPECT_NE(out_.find("What failed, and why"), std::string::npos);
}

TEST_F(CorpusRun, WhatLeavesItsRangeIsInaccurate) {
  for (const char* file : {"lattice.toml", "packings/lattice.csv"}) {
    fs::create_directories(folder_.file("cases/packings"));
    fs::copy_file(std::string(SUPERSTEP_SOURCE_DIR) + "/cases/" + file, folder_.file("cases") + "/" + file);
  }
  ASSERT_EQ(bench({"--integrator", "sts:n=20,nu=1e-5", "rkc:rtol=1e-3"}), 0);
  for (const auto& row : rows())
    if (row.scene == "lattice" && row.integrator == "sts") {
      EXPECT_EQ(row.status, "inaccurate");
      EXPECT_TRUE(row.error && row.cpu) << "they stand beside it";
      EXPECT_NE(row.reason.find("leaves the range"), std::string::npos) << row.reason;
    }
}

TEST_F(CorpusRun, WritesTheReport) {
  ASSERT_EQ(bench({"--integrator", "rkc", "exponential:rtol=1e-6", "--report"}), 0);
  const std::string page = folder_.read("out/report.html");
  for (const char* part :
       {"id=\"corpus\"", "id=\"corpus-map\"", "id=\"corpus-profiles\"", "corpus-profile-all"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
}

TEST_F(CorpusRun, SaysWhatDoesNotGoTogether) {
  EXPECT_EQ(bench({"--work-precision"}), 2);
  EXPECT_EQ(bench({"--integrator", "nobody"}), 2);
  folder_.write("cases/broken.toml", "t_end = -1\n");
  EXPECT_EQ(bench({}), 3);
  EXPECT_FALSE(folder_.has("out"));
}

}  // namespace
}  // namespace superstep
