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

/// Timings around `seconds`, with one per cent of noise.
void time(BenchRow& row, double seconds, int rounds = 9) {
  row.cpu_stepping = Timing{seconds, 0.99 * seconds, 1.01 * seconds};
  row.cpu_stepping_samples.clear();
  for (int k = 0; k < rounds; ++k) row.cpu_stepping_samples.push_back(seconds * (1 + 0.01 * (k % 3 - 1)));
  row.yardstick_samples.assign(static_cast<std::size_t>(rounds), 0.01);
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
  BenchReport before = plain_report();
  BenchReport now = before;
  now.cases[0].rows[1].rhs = 1001;
  time(before.cases[0].rows[2], 0.2);
  time(now.cases[0].rows[2], 1);
  const std::string text = markdown_summary(now, &before);
  EXPECT_TRUE(text.starts_with("**Worse.** 1 worse, 0 better, 1 otherwise"));
  EXPECT_TRUE(has(text, "sweeps 1000 → 1001"));
  EXPECT_TRUE(has(text, "5×"));
  EXPECT_FALSE(has(text, "forward-euler")) << "it has not changed";
}

TEST(MarkdownSummary, TimesThatCannotTellAreNoChange) {
  BenchReport before = plain_report(), now = before;
  time(before.cases[0].rows[1], 0.2, 3);
  time(now.cases[0].rows[1], 0.4, 3);  // all of them longer than any before: one in ten is, of three
  const std::string text = markdown_summary(now, &before);
  EXPECT_TRUE(text.starts_with("**Unchanged.**")) << text;
  EXPECT_TRUE(has(text, "Times that cannot tell are left out. Times can tell from 6 rounds")) << text;
}

TEST(MarkdownSummary, TimesOfAnotherMachineAreNoChange) {
  BenchReport before = plain_report();
  time(before.cases[0].rows[1], 0.2);
  BenchReport now = before;
  time(now.cases[0].rows[1], 0.4);
  EXPECT_TRUE(markdown_summary(now, &before).starts_with("**Worse.**"));
  BenchReport another = now;
  another.machine[0].value = "another processor";
  const std::string text = markdown_summary(another, &before);
  EXPECT_TRUE(text.starts_with("**Unchanged.**")) << text;
  EXPECT_TRUE(has(text, "Times are left out: processor, flags or threads")) << text;
  now.cases[0].rows[1].processes = 2;  // whose times are added up
  EXPECT_TRUE(markdown_summary(now, &before).starts_with("**Unchanged.**"));
}

TEST(MarkdownSummary, OverlappingTimesAreNoChange) {
  BenchReport before = plain_report(), now = before;
  for (auto* report : {&before, &now})
    for (auto& row : report->cases[0].rows) time(row, 0.2);
  time(now.cases[0].rows[1], 0.204);
  EXPECT_EQ(markdown_summary(now, &before), "**Unchanged.** No run differs from the benchmark before.\n");
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
