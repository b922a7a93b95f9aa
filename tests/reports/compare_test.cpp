#include "reports/gate/compare.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "measured_results.hpp"
#include "reports/gate/gate.hpp"

namespace superstep {
namespace {

using test::Machine;
using test::measured;

TEST(Compare, IdenticalWorkIsNotASpeedup) {
  int claims = 0, rows = 0;
  for (unsigned seed = 1; seed <= 20; ++seed)
    for (const auto& row : compare(measured({}, seed), measured({}, seed + 100))) {
      claims += std::string(row.words()) != "no clear difference" ? 1 : 0;
      ++rows;
    }
  EXPECT_EQ(rows, 40);
  EXPECT_EQ(claims, 0);  // the interval holds 99 %, and 5 % are never worth a word
}

TEST(Compare, SeesATenthAndCountsWork) {
  const auto rows = compare(measured({}, 1), measured({.sweep = 0.9, .extra_sweeps = 1}, 2));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_STREQ(rows[0].words(), "B is faster");
  EXPECT_DOUBLE_EQ(*rows[0].work, 2.0);
  EXPECT_TRUE(rows[0].in_yardsticks);
}

TEST(Compare, FewRoundsTellNothingAndShortOnesNeither) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto few =
        compare(measured({.rounds = 3}, seed), measured({.sweep = 0.5, .rounds = 3}, seed + 100));
    EXPECT_STREQ(few[0].words(), "too few rounds to tell");
  }
  auto a = measured({}, 1), b = measured({.sweep = 0.5}, 2);
  for (auto* file : {&a, &b})
    for (double& time : file->cases[0].rows[0].cpu_stepping) time *= 1e-3;
  const auto rows = compare(a, b);
  EXPECT_STREQ(rows[0].words(), "too short to tell");
  const auto text = compare_markdown(a, b, rows);
  EXPECT_NE(text.find("Times can tell from 6 rounds and 5 ms on"), std::string::npos) << text;
}

TEST(Compare, NamesWhatStandsInOneOfThemOnly) {
  const auto a = measured({}, 1);
  auto b = a;
  b.cases[0].rows.pop_back();
  b.cases.push_back({"ladder", "rkc", {}});
  const auto text = compare_markdown(a, b, compare(a, b));
  EXPECT_NE(text.find("Only in A: `rkc:rtol=1e-4` on rod.\n"), std::string::npos) << text;
  EXPECT_NE(text.find("Only in B: case ladder.\n"), std::string::npos) << text;
  b.cases[0].name = "bar";
  const auto nothing = compare_markdown(a, b, compare(a, b));
  EXPECT_NE(nothing.find("Nothing to compare"), std::string::npos) << nothing;
  EXPECT_EQ(nothing.find("| case"), std::string::npos) << nothing;
}

TEST(Compare, NamesWhatTimesDependOn) {
  const auto a = measured({}, 1);
  auto b = measured({}, 2);
  b.threads = 4;
  for (auto& row : b.cases[0].rows) row.numbers["processes"] = 2;
  const auto text = compare_markdown(a, b, compare(a, b));
  EXPECT_NE(text.find("The numbers of threads differ: '1' and '4'."), std::string::npos) << text;
  EXPECT_NE(text.find("The numbers of processes differ: '1' and '2'."), std::string::npos) << text;
  EXPECT_EQ(text.find("processors differ"), std::string::npos) << text;
}

TEST(Compare, RefusesTwoCasesOfOneName) {
  const auto a = measured({}, 1);
  const auto expect_refused = [&](const char* what, const auto& change) {
    auto b = measured({}, 2);
    change(b.cases[0].head);
    EXPECT_THROW((void)compare(a, b), InputError) << what;
    EXPECT_THROW((void)judge(b, a, [](const std::string&) { return false; }), InputError) << what;
  };
  expect_refused("size", [](BenchCase& one) { one.nodes += 1; });
  expect_refused("output times", [](BenchCase& one) { one.output_times = {0.5, 1}; });
  expect_refused("kelvin against volts", [](BenchCase& one) { one.unit = "V"; });
}

TEST(Bootstrap, IntervalHoldsTheTruthAndShrinks) {
  int held = 0;
  double few = 0, many = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    const auto pair = [&](double seconds, int rounds, unsigned which) {
      auto times = Machine(seed * 10 + which, 0.02).measure({seconds, 1.0}, rounds);
      return PairedTimings{times[0], times[1]};
    };
    const auto wide = slowdown(pair(1.2, 9, 1), pair(1.0, 9, 2));
    const auto narrow = slowdown(pair(1.2, 81, 3), pair(1.0, 81, 4));
    held += wide.low <= 1.2 && 1.2 <= wide.high ? 1 : 0;
    few += wide.high - wide.low;
    many += narrow.high - narrow.low;
  }
  EXPECT_GE(held, 37);         // of 40 at 99 %, less what the bootstrap of nine medians lacks
  EXPECT_LT(many, 0.6 * few);  // sqrt(81/9) = 3 times narrower in the limit
}

}  // namespace
}  // namespace superstep
