#include "bench/harness/harness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>

#include "bench/app/loaded_case.hpp"
#include "bench/harness/instructions.hpp"
#include "core/error.hpp"
#include "integrators/method_spec.hpp"
#include "support/temporary_case.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

using test::CaseFolder;
using test::Rod;

TEST(Harness, RoundsRotateTheOrder) {
  EXPECT_EQ(round_order(3, 0), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(round_order(3, 1), (std::vector<std::size_t>{1, 2, 0}));
  EXPECT_EQ(round_order(3, 5), (std::vector<std::size_t>{2, 0, 1}));
}

TEST(Harness, TimingIsTheMedianWithItsExtremes) {
  const Timing odd = summarize({3, 1, 2}), even = summarize({4, 1, 2, 3});
  EXPECT_EQ(odd.median, 2);
  EXPECT_EQ(odd.min, 1);
  EXPECT_EQ(odd.max, 3);
  EXPECT_EQ(even.median, 2.5);
}

class RodBench : public testing::Test {
 protected:
  BenchCase bench() { return bench_case(scene_, 0.5, options_, silent_); }
  static const BenchRow& row(const BenchCase& one, const std::string& spec) {
    const auto found =
        std::find_if(one.rows.begin(), one.rows.end(), [&](const BenchRow& r) { return r.spec == spec; });
    if (found == one.rows.end()) throw std::out_of_range("no row " + spec);
    return *found;
  }

  CaseFolder folder_;
  Scene scene_ = std::get<Scene>(load_bench_case(write_rod(folder_, Rod{})).content);
  HarnessOptions options_;
  Progress silent_{false};
};

TEST_F(RodBench, TheBaselineIsAppendedOnce) {
  EXPECT_EQ(contenders(scene_.bench, {}).back(), "forward-euler");
  EXPECT_EQ(contenders(scene_.bench, {"forward-euler", "sts"}),
            (std::vector<std::string>{"forward-euler", "sts"}));
}

TEST_F(RodBench, EveryIntegratorOfTheCaseIsMeasured) {
  const BenchCase one = bench();
  ASSERT_EQ(one.rows.size(), 3U);
  EXPECT_EQ(one.unit, "K");
  EXPECT_EQ(one.nodes, 20U);
  EXPECT_EQ(one.contacts, 19U);
  EXPECT_EQ(one.unknowns, 18U);
  for (const auto& r : one.rows) {
    SCOPED_TRACE(r.spec);
    EXPECT_EQ(r.status, "ok") << r.reason;
    EXPECT_EQ(r.repetitions, 3);
    EXPECT_EQ(r.reference, "exponential:basis=chebyshev,rtol=1e-14");
    ASSERT_TRUE(r.cpu_stepping && r.cpu_total);
    EXPECT_GT(r.cpu_stepping->median, 0);
    EXPECT_GE(r.cpu_total->median, 0.5 + r.cpu_stepping->min) << "set-up of the scene is part of the total";
    EXPECT_TRUE(r.speedup_stepping && r.speedup_total);
    EXPECT_GT(r.steps.value(), 0U);
    EXPECT_GT(r.rhs.value(), 0U);
    EXPECT_GT(r.peak_memory_mb.value(), 0);
    EXPECT_TRUE(r.errors.rms && r.errors.probe_mean && r.errors.decay_rate && r.errors.reference_error);
    EXPECT_FALSE(r.potential);
  }
}

TEST_F(RodBench, SpeedupsAreRelativeToTheBaseline) {
  const BenchCase one = bench();
  const BenchRow &euler = row(one, "forward-euler"), &sts = row(one, "sts:n=5,nu=0.05"),
                 &cvode = row(one, "cvode:rtol=1e-4");
  EXPECT_EQ(euler.speedup_stepping, 1);
  EXPECT_EQ(euler.speedup_theory, 1);
  EXPECT_GT(sts.speedup_theory.value(), 1) << "a superstep covers more time per sweep";
  EXPECT_FALSE(cvode.speedup_theory) << "no fixed ratio of time to sweeps";
  EXPECT_EQ(sts.rhs.value(), 5 * sts.steps.value());
}

TEST_F(RodBench, AFailingMethodIsARowAndTheOthersGoOn) {
  options_.integrators = {"forward-euler:step=0.7", "sts:n=5,nu=0.05"};
  const BenchCase one = bench();
  ASSERT_EQ(one.rows.size(), 3U);
  const BenchRow& failed = row(one, "forward-euler:step=0.7");
  EXPECT_EQ(failed.status, "unstable");
  EXPECT_FALSE(failed.reason.empty());
  EXPECT_EQ(failed.repetitions, 0);
  EXPECT_FALSE(failed.cpu_stepping);
  EXPECT_FALSE(failed.errors.rms);
  EXPECT_EQ(row(one, "sts:n=5,nu=0.05").status, "ok");
}

TEST_F(RodBench, WithoutABaselineThereAreNoSpeedups) {
  scene_.bench.baseline = "forward-euler:step=0.7";
  options_.integrators = {"sts:n=5,nu=0.05"};
  const BenchCase one = bench();
  EXPECT_FALSE(row(one, "sts:n=5,nu=0.05").speedup_stepping);
  EXPECT_TRUE(row(one, "sts:n=5,nu=0.05").cpu_stepping);
}

TEST_F(RodBench, AFailingReferenceIsAWarningAndTimingsRemain) {
  options_.reference = "forward-euler:step=0.7";
  const BenchCase one = bench();
  EXPECT_FALSE(one.reference);
  EXPECT_EQ(one.warnings.size(), 1U);
  EXPECT_TRUE(one.rows[0].cpu_stepping);
  EXPECT_FALSE(one.rows[0].errors.rms);
  EXPECT_EQ(one.rows[0].reference, "");
}

TEST_F(RodBench, AReferenceThatErrsIsHeldAgainstNoMethod) {
  options_.reference = "forward-euler";
  options_.integrators = {"exponential:rtol=1e-10", "cvode:rtol=0.1"};
  const BenchCase one = bench();
  const BenchRow &exact = row(one, "exponential:rtol=1e-10"), &loose = row(one, "cvode:rtol=0.1");
  EXPECT_EQ(exact.status, "ok") << exact.reason;
  EXPECT_FALSE(exact.errors.delivered);
  EXPECT_TRUE(loose.errors.delivered);
  ASSERT_EQ(one.warnings.size(), 1U);
  EXPECT_EQ(one.warnings[0],
            "the reference forward-euler is not known well enough to tell whether exponential:rtol=1e-10 "
            "keeps the tolerance asked for; give a tighter --reference, or none");
}

TEST_F(RodBench, TheSecondBenchTakesTheReferenceFromTheCache) {
  options_.repetitions = 1;
  EXPECT_FALSE(bench().reference.value().from_cache);
  EXPECT_TRUE(bench().reference.value().from_cache);
}

TEST(Instructions, AnInterruptEndsTheCount) {
  const test::TemporaryFolder folder;
  const std::string endless = folder.write("endless", "#!/bin/sh\nwhile :; do :; done\n");
  std::filesystem::permissions(endless, std::filesystem::perms::owner_all);
  const std::atomic<bool> stop = true;
  const auto counted = count_instructions(endless, "case.toml", "rkc", &stop);
  EXPECT_FALSE(counted.instructions);
  EXPECT_FALSE(counted.reason.empty());
}

TEST_F(RodBench, AnInterruptedBenchReportsWhatIsVerified) {
  const std::atomic<bool> stop{true};
  options_.stop = &stop;
  EXPECT_TRUE(bench().rows.empty());
}

TEST(MethodSpec, ToleranceReplacesRtol) {
  EXPECT_EQ(MethodSpec("cvode").with_tolerance(1e-7).text(), "cvode:rtol=1e-07");
  EXPECT_EQ(MethodSpec("cvode:rtol=1e-3,linsol=klu").with_tolerance(0.5e-7).text(),
            "cvode:rtol=5e-08,linsol=klu");
  EXPECT_EQ(MethodSpec("cvode").with_tolerance(1e-7).rtol(), 1e-7);
  const auto message =
      test::message_of<UsageError>([] { (void)MethodSpec("forward-euler").with_tolerance(1e-3); });
  EXPECT_TRUE(message.starts_with("forward-euler has no relative tolerance")) << message;
  EXPECT_EQ(message.find("--"), std::string::npos) << "Python asks for it by another name";
  EXPECT_THROW((void)MethodSpec("rkc").with_tolerance(2), UsageError);
}

TEST(MethodSpec, TakesDefaultsFromTheTableOfKeys) {
  for (const auto& entry : integrators())
    for (const auto& key : entry.keys)
      if (key.name == "rtol" && entry.adaptive) {
        EXPECT_EQ(MethodSpec(entry.name).rtol(), std::stod(key.fallback)) << entry.name;
      }
}

TEST(MethodSpec, FolderNamesAreHarmless) {
  EXPECT_EQ(folder_name("sts:n=20,nu=1e-4"), "sts_n=20_nu=1e-4");
  EXPECT_EQ(folder_name("a/../b c"), "a_.._b_c");
}

}  // namespace
}  // namespace superstep
