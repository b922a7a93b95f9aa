#include "reports/gate/gate.hpp"

#include <gtest/gtest.h>

#include "measured_results.hpp"

namespace superstep {
namespace {

using test::measured;

bool is_adaptive(const std::string& name) {
  return name == "rkc";
}

GateReport gate(const ResultsFile& now, const ResultsFile& before) {
  return judge(now, before, is_adaptive);
}

bool mentions(const GateReport& report, const std::string& what, GateVerdict verdict) {
  for (const auto& finding : report.findings)
    if (finding.what == what && finding.verdict == verdict) return true;
  return false;
}

TEST(Gate, PassesAnUnchangedBuildTenTimesOutOfTen) {
  const auto before = measured({}, 1);
  for (unsigned seed = 2; seed < 12; ++seed)
    EXPECT_EQ(gate(measured({}, seed), before).verdict, GateVerdict::passed)
        << gate_markdown(gate(measured({}, seed), before));
}

TEST(Gate, FailsWhenSweepsAreATenthSlower) {
  const auto before = measured({}, 1);
  for (unsigned seed = 2; seed < 12; ++seed) {
    const auto report = gate(measured({.sweep = 1.10}, seed), before);
    EXPECT_EQ(report.verdict, GateVerdict::regressed) << gate_markdown(report);
    EXPECT_TRUE(mentions(report, "CPU in yardsticks", GateVerdict::regressed));
  }
}

/// Results with counts of instructions, timed on a machine on which no time tells anything.
ResultsFile counted(double factor, unsigned seed) {
  auto file = measured({.rounds = 1, .noise = 0.5}, seed);
  file.counted_by = "valgrind-3.19.0, avx2; a compiler";
  for (auto& row : file.cases[0].rows) row.numbers["instructions"] = 1e9;
  file.cases[0].rows[1].numbers["instructions"] = 1e8 * factor;
  return file;
}

TEST(Gate, PassesEqualCountsOnABusyMachineTwentyTimesOutOfTwenty) {
  const auto before = counted(1, 1);
  for (unsigned seed = 2; seed < 22; ++seed) {
    const double jitter = seed % 2 ? 1.0005 : 0.9995;  // what addresses and hashes change
    const auto report = gate(counted(jitter, seed), before);
    EXPECT_EQ(report.verdict, GateVerdict::passed) << gate_markdown(report);
  }
}

TEST(Gate, FailsOnTwoPercentMoreInstructions) {
  const auto report = gate(counted(1.02, 2), counted(1, 1));
  EXPECT_EQ(report.verdict, GateVerdict::regressed);
  EXPECT_TRUE(mentions(report, "instructions", GateVerdict::regressed));
  EXPECT_EQ(gate(counted(0.98, 2), counted(1, 1)).verdict, GateVerdict::passed);
}

TEST(Gate, CannotTellFromCountsOfAnotherBuildOrNone) {
  auto other = counted(1, 2);
  other.counted_by = "valgrind-3.19.0, avx2; another compiler";
  EXPECT_EQ(gate(other, counted(1, 1)).verdict, GateVerdict::inconclusive);
  auto none = measured({}, 2);
  EXPECT_EQ(gate(none, counted(1, 1)).verdict, GateVerdict::inconclusive);
}

TEST(Gate, AFindingAboutAWholeCaseNamesNoMethod) {
  auto now = measured({}, 2);
  now.cases[0].name = "another";
  const auto text = gate_markdown(gate(now, measured({}, 1)));
  EXPECT_NE(text.find("| all | case |"), std::string::npos) << text;
  EXPECT_EQ(text.find("``"), std::string::npos) << text;
}

TEST(Gate, FailsWhenOneMethodIsATenthSlower) {
  const auto report = gate(measured({.rkc = 1.10}, 2), measured({}, 1));
  EXPECT_EQ(report.verdict, GateVerdict::regressed);
  EXPECT_TRUE(mentions(report, "CPU to baseline", GateVerdict::regressed));
}

TEST(Gate, FailsOnOneSweepMorePerStep) {
  const auto report = gate(measured({.extra_sweeps = 1}, 2), measured({}, 1));
  EXPECT_EQ(report.verdict, GateVerdict::regressed);
  int methods = 0;
  for (const auto& finding : report.findings) methods += finding.what == "rhs" ? 1 : 0;
  EXPECT_EQ(methods, 2) << "fixed steps and adaptive: " << gate_markdown(report);
}

TEST(Gate, FailsOnAnErrorTenTimesLarger) {
  const auto report = gate(measured({.error = 10}, 2), measured({}, 1));
  EXPECT_EQ(report.verdict, GateVerdict::regressed);
  EXPECT_TRUE(mentions(report, "error_rms", GateVerdict::regressed));
}

TEST(Gate, ErrorsWithinTheReferencesBarSayNothing) {
  auto before = measured({}, 1), now = measured({}, 2);
  before.cases[0].rows[1].numbers["error_rms"] = 1e-9;
  now.cases[0].rows[1].numbers["error_rms"] = 1e-8;  // the bar is 1e-7
  EXPECT_EQ(gate(now, before).verdict, GateVerdict::passed);
}

TEST(Gate, AnErrorThatOnlyTheBarOfAWorseReferenceExcusesCannotBeTold) {
  const auto before = measured({}, 1);
  auto now = measured({}, 2);
  auto& numbers = now.cases[0].rows[1].numbers;
  numbers["reference_error"] = 1;
  EXPECT_EQ(gate(now, before).verdict, GateVerdict::passed) << "the errors are what they were";
  numbers["error_rms"] *= 100;
  const auto report = gate(now, before);
  EXPECT_EQ(report.verdict, GateVerdict::inconclusive);
  EXPECT_TRUE(mentions(report, "error_rms", GateVerdict::inconclusive));
}

TEST(Gate, FixedStepsToleratesNoExtraWorkAdaptiveAFiftieth) {
  const auto before = measured({}, 1);
  auto now = measured({}, 2);
  now.cases[0].rows[1].numbers["rhs"] = 1420;  // + 1.4 %
  EXPECT_EQ(gate(now, before).verdict, GateVerdict::passed);
  now.cases[0].rows[0].numbers["rhs"] = 1001;
  EXPECT_EQ(gate(now, before).verdict, GateVerdict::regressed);
}

TEST(Gate, SaysInconclusiveWhenNoiseHidesTheAnswer) {
  int inconclusive = 0;
  for (unsigned seed = 2; seed < 12; ++seed) {
    const auto report =
        gate(measured({.rounds = 7, .noise = 0.3}, seed), measured({.rounds = 7, .noise = 0.3}, seed + 50));
    EXPECT_NE(report.verdict, GateVerdict::passed) << "30 % noise cannot show that nothing got slower";
    inconclusive += report.verdict == GateVerdict::inconclusive ? 1 : 0;
  }
  EXPECT_GE(inconclusive, 9);  // 99 % intervals: a false alarm is rare, not impossible
}

TEST(Gate, TimingsThatDisagreeWithThemselvesAreNotTrusted) {
  auto now = measured({}, 2);
  auto& times = now.cases[0].rows[1].cpu_stepping;
  for (std::size_t k = 1; k < times.size(); k += 2) times[k] *= 1.3;
  const auto report = gate(now, measured({}, 1));
  EXPECT_EQ(report.verdict, GateVerdict::inconclusive) << gate_markdown(report);
}

TEST(Gate, AnotherProcessorIsNotJudgedByItsTimes) {
  auto now = measured({.sweep = 2}, 2);
  now.processor = "another processor";
  const auto report = gate(now, measured({}, 1));
  EXPECT_EQ(report.verdict, GateVerdict::passed);
  EXPECT_FALSE(report.notes.empty());
  now.cases[0].rows[0].numbers["rhs"] = 2000;
  EXPECT_EQ(gate(now, measured({}, 1)).verdict, GateVerdict::regressed) << "counters always count";
}

TEST(Gate, AMethodThatWasNotMeasuredCannotBeToldLikeACase) {
  const auto before = measured({}, 1);
  auto now = before;
  now.cases[0].rows.pop_back();
  const auto report = gate(now, before);
  EXPECT_EQ(report.verdict, GateVerdict::inconclusive);
  ASSERT_FALSE(report.notes.empty());
  EXPECT_EQ(report.notes.back(), "Not measured here, so that nobody can tell: rkc:rtol=1e-4 on rod.");
  now.cases[0].rows.clear();
  EXPECT_EQ(gate(now, before).verdict, GateVerdict::inconclusive) << "nothing was measured";
}

TEST(Gate, AnInterruptBetweenTwoMethodsCostsOneRoundAndIsSaid) {
  const auto before = measured({}, 1);
  auto now = measured({.rkc = 1.10}, 2);
  now.interrupted = true;
  now.cases[0].rows[1].cpu_stepping.pop_back();
  now.cases[0].rows[1].yardstick.pop_back();
  const auto report = gate(now, before);
  EXPECT_TRUE(mentions(report, "CPU to baseline", GateVerdict::regressed)) << gate_markdown(report);
  ASSERT_FALSE(report.notes.empty());
  EXPECT_EQ(report.notes[0], "'synthetic' was interrupted: what had been measured by then is judged.");
}

TEST(Gate, TimesThatAnInterruptCutShortCannotBeTold) {
  auto now = measured({.rounds = 3}, 2);
  EXPECT_EQ(gate(now, measured({}, 1)).verdict, GateVerdict::passed) << "nobody asked for more";
  now.interrupted = true;
  EXPECT_EQ(gate(now, measured({}, 1)).verdict, GateVerdict::inconclusive);
}

TEST(Gate, FailsOnMoreMemoryThanRunsVaryBy) {
  const auto with = [](double memory, unsigned seed) {
    auto file = measured({}, seed);
    for (auto& row : file.cases[0].rows) row.numbers["peak_memory_mb"] = memory;
    return file;
  };
  EXPECT_EQ(gate(with(23, 2), with(16, 1)).verdict, GateVerdict::passed) << "libraries, other methods";
  EXPECT_EQ(gate(with(1090, 2), with(1000, 1)).verdict, GateVerdict::passed);
  EXPECT_EQ(gate(measured({}, 2), with(1000, 1)).verdict, GateVerdict::passed) << "nobody recorded it";
  const auto report = gate(with(1110, 2), with(1000, 1));
  EXPECT_EQ(report.verdict, GateVerdict::regressed);
  EXPECT_TRUE(mentions(report, "peak_memory_mb", GateVerdict::regressed));
  EXPECT_TRUE(mentions(gate(with(500, 2), with(1000, 1)), "peak_memory_mb", GateVerdict::better));
  auto threads = with(2000, 2);
  threads.threads = 8;
  EXPECT_EQ(gate(threads, with(1000, 1)).verdict, GateVerdict::passed) << "each thread has its stack";
}

TEST(Gate, FailsWhereARangeIsLeftFurther) {
  const auto with = [](double overshoot, unsigned seed) {
    auto file = measured({}, seed);
    file.cases[0].rows[1].numbers["overshoot"] = overshoot;
    file.cases[0].rows[1].numbers["span"] = 10;
    return file;
  };
  EXPECT_EQ(gate(with(1e-6, 2), with(0, 1)).verdict, GateVerdict::passed) << "a ten-millionth of the span";
  EXPECT_EQ(gate(with(0.0515, 2), with(0.05, 1)).verdict, GateVerdict::passed);
  const auto report = gate(with(0.06, 2), with(0.05, 1));
  EXPECT_EQ(report.verdict, GateVerdict::regressed);
  EXPECT_TRUE(mentions(report, "overshoot", GateVerdict::regressed));
}

TEST(Gate, TimesInOtherUnitsAreNoRegression) {
  const auto before = measured({}, 1);
  auto now = measured({}, 2);
  now.cases[0].baseline = "rkc:rtol=1e-4";  // forward Euler takes ten times as long
  EXPECT_EQ(gate(now, before).verdict, GateVerdict::inconclusive) << gate_markdown(gate(now, before));
  now = measured({.sweep = 2}, 2);
  for (auto& row : now.cases[0].rows) row.numbers["processes"] = 2;  // their times are added up
  EXPECT_EQ(gate(now, before).verdict, GateVerdict::passed) << gate_markdown(gate(now, before));
}

TEST(Gate, WhatFailsIsARegression) {
  const auto before = measured({}, 1);
  auto now = before;
  now.cases[0].rows[1].status = "unstable";
  EXPECT_EQ(gate(now, before).verdict, GateVerdict::regressed);
  now = before;
  now.cases[0].rows[1].numbers.erase("error_rms");
  EXPECT_EQ(gate(now, before).verdict, GateVerdict::regressed);
  now.cases.clear();
  EXPECT_EQ(gate(now, before).verdict, GateVerdict::inconclusive) << "a case is not measured";
  EXPECT_EQ(gate(before, now).verdict, GateVerdict::inconclusive) << "nothing to compare is not a pass";
}

TEST(Gate, WhatIsInaccurateIsJudgedLikeWhatIsNot) {
  auto before = measured({}, 1), now = measured({.error = 10}, 2);
  for (auto* file : {&before, &now}) file->cases[0].rows[1].status = "inaccurate";
  EXPECT_EQ(gate(before, before).verdict, GateVerdict::passed);
  const auto report = gate(now, before);
  int errors = 0;
  for (const auto& finding : report.findings)
    errors += finding.spec == "rkc:rtol=1e-4" && finding.what == "error_rms" ? 1 : 0;
  EXPECT_EQ(errors, 1) << gate_markdown(report);
}

TEST(Gate, LessWorkPassesAndAsksForANewBaseline) {
  auto now = measured({}, 2);
  now.cases[0].rows[0].numbers["rhs"] = 900;
  const auto report = gate(now, measured({}, 1));
  EXPECT_EQ(report.verdict, GateVerdict::passed);
  EXPECT_TRUE(mentions(report, "rhs", GateVerdict::better));
}

}  // namespace
}  // namespace superstep
