#include "reports/text/markdown_summary.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "sample_report.hpp"

namespace superstep {
namespace {

BenchReport plain_report() {
  BenchReport report = test::sample_report();
  report.cases[0].rows.resize(3);
  report.cases[0].name = "rod";
  for (auto& row : report.cases[0].rows) row.case_name = "rod";
  return report;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(MarkdownSummary, TheVerdictComesFirst) {
  EXPECT_TRUE(markdown_summary(plain_report(), nullptr).starts_with("**All 3 runs succeeded.**"));
  const std::string failed = markdown_summary(test::sample_report(), nullptr);
  EXPECT_TRUE(failed.starts_with("**1 of 5 runs failed.**"));
  EXPECT_FALSE(has(failed, "<script>")) << "names are text";
  EXPECT_TRUE(markdown_summary(BenchReport{}, nullptr).starts_with("**Nothing"));
}

TEST(MarkdownSummary, TheSameBenchmarkIsUnchanged) {
  const BenchReport report = plain_report();
  EXPECT_TRUE(markdown_summary(report, &report).starts_with("**Unchanged.**"));
}

TEST(MarkdownSummary, ListsChangedRowsOnly) {
  const BenchReport before = plain_report();
  BenchReport now = before;
  now.cases[0].rows[1].rhs = 1001;
  now.cases[0].rows[2].cpu_stepping = Timing{1, 0.9, 1.1};  // 0.18 .. 0.24 before
  const std::string text = markdown_summary(now, &before);
  EXPECT_TRUE(text.starts_with("**Worse.** 1 worse, 0 better, 1 otherwise"));
  EXPECT_TRUE(has(text, "sweeps 1000 → 1001"));
  EXPECT_TRUE(has(text, "5×"));
  EXPECT_FALSE(has(text, "forward-euler")) << "it has not changed";
}

TEST(MarkdownSummary, OverlappingTimesAreNoChange) {
  const BenchReport before = plain_report();
  BenchReport now = before;
  now.cases[0].rows[1].cpu_stepping = Timing{0.36, 0.35, 0.4};  // 0.27 .. 0.36 before
  EXPECT_TRUE(markdown_summary(now, &before).starts_with("**Unchanged.**"));
}

TEST(MarkdownSummary, NewGoneAndFailedRuns) {
  const BenchReport before = plain_report();
  BenchReport now = before;
  now.cases[0].rows[0].status = "unstable";
  now.cases[0].rows[1].spec = "sts:n=99";
  const std::string text = markdown_summary(now, &before);
  EXPECT_TRUE(has(text, "ok → unstable"));
  EXPECT_TRUE(has(text, "| sts:n=99 | new |"));
  EXPECT_TRUE(has(text, "| gone |"));
}

}  // namespace
}  // namespace superstep
