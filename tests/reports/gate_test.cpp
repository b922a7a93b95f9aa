#include "reports/gate/gate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.hpp"
#include "reports/gate/compare.hpp"
#include "results/results_json.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

bool is_adaptive(const std::string& name) {
  return name == "rkc";
}

/// Timings of a noisy machine: every round slower or faster as a whole, every run by itself, and now and then
/// one that was interrupted.
class Machine {
 public:
  Machine(unsigned seed, double noise) : random_(seed), noise_(noise) {}

  /// `rounds` timings of pieces of work that take `seconds` each.
  std::vector<std::vector<double>> measure(const std::vector<double>& seconds, int rounds) {
    std::vector<std::vector<double>> out(seconds.size());
    for (int round = 0; round < rounds; ++round) {
      const double weather = std::exp(0.2 * normal_(random_));
      for (std::size_t k = 0; k < seconds.size(); ++k) {
        const double hiccup = uniform_(random_) < 0.05 ? 1.5 : 1;
        out[k].push_back(seconds[k] * weather * hiccup * std::exp(noise_ * normal_(random_)));
      }
    }
    return out;
  }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_;
  double noise_;
};

struct Build {
  double sweep = 1;         ///< cost of a sweep
  double rkc = 1;           ///< cost of the method besides
  double extra_sweeps = 0;  ///< per step
  double error = 1;         ///< times what it was
  int rounds = 21;
  double noise = 0.01;
};

MeasuredRow row_of(const std::string& spec, double steps, double rhs, double error) {
  MeasuredRow row;
  row.spec = spec;
  row.integrator = spec.substr(0, spec.find(':'));
  row.status = "ok";
  row.numbers = {{"steps", steps},          {"rejected", 0},   {"rhs", rhs},         {"jacobians", 0},
                 {"factorizations", 0},     {"solves", 0},     {"error_rms", error}, {"error_max", 3 * error},
                 {"reference_error", 1e-7}, {"balance", 1e-14}};
  return row;
}

ResultsFile measured(const Build& build, unsigned seed) {
  auto euler = row_of("forward-euler", 1000, 1000 * (1 + build.extra_sweeps), 1e-3 * build.error);
  auto rkc = row_of("rkc:rtol=1e-4", 70, 1400 + 70 * build.extra_sweeps, 2e-3 * build.error);
  const auto times =
      Machine(seed, build.noise)
          .measure({1.0 * build.sweep, 0.01, 0.1 * build.sweep * build.rkc, 0.01}, build.rounds);
  euler.cpu_stepping = times[0];
  euler.yardstick = times[1];
  rkc.cpu_stepping = times[2];
  rkc.yardstick = times[3];
  ResultsFile file;
  file.path = "synthetic";
  file.processor = "a processor";
  file.flags = "-O3";
  file.cases = {{"rod", "forward-euler", {euler, rkc}}};
  return file;
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

TEST(Gate, LessWorkPassesAndAsksForANewBaseline) {
  auto now = measured({}, 2);
  now.cases[0].rows[0].numbers["rhs"] = 900;
  const auto report = gate(now, measured({}, 1));
  EXPECT_EQ(report.verdict, GateVerdict::passed);
  EXPECT_TRUE(mentions(report, "rhs", GateVerdict::better));
}

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

TEST(Compare, RefusesTwoCasesOfOneName) {
  auto a = measured({}, 1), b = measured({}, 2);
  a.cases[0].rows[0].numbers["nodes"] = 7;
  b.cases[0].rows[0].numbers["nodes"] = 20;
  EXPECT_THROW((void)compare(a, b), InputError);
  EXPECT_THROW((void)gate(b, a), InputError);
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
