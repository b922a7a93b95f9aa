#include "bench/harness/verification.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/temporary_case.hpp"

namespace superstep {
namespace {

using test::CaseFolder;
using test::Rod;

void append(ProbeHistory& history, double t, double value) {
  history.append(t, std::array{value});
}

TEST(ProbeErrors, AreTakenAtTheMethodsOwnStepEnds) {
  ProbeHistory reference(1), run(1);
  for (const double t : {0.0, 1.0, 2.0, 3.0, 4.0})
    append(reference, t, 8 - 2 * t);  // linear between, ends at 0
  append(run, 0, 8);
  append(run, 0.5, 7.5);   // reference 7
  append(run, 1.5, 4);     // reference 5
  append(run, 2.5, 3.5);   // reference 3
  append(run, 3.5, 1.25);  // reference 1
  append(run, 4, 3);       // reference at its final value: not part of the transient
  append(run, 9, 77);      // a step beyond the end
  FieldErrors errors;
  measure_probe_errors(run, reference, 0, 4, errors);
  EXPECT_DOUBLE_EQ(errors.probe_mean.value(), (0.5 + 1 + 0.5 + 0.25) / 4);
  // From the largest error on it halves every second; the rise to it is no decay.
  EXPECT_NEAR(errors.decay_rate.value(), std::log(2.0), 1e-12);
  EXPECT_NEAR(errors.decay_r2.value(), 1, 1e-12);
}

TEST(Judge, FarOffIsInaccurate) {
  FieldErrors errors;
  errors.span = 1000;
  errors.rms = 90;
  errors.relative_rms = 0.09;
  Outcome outcome;
  judge(errors, "temperature", "K", outcome);
  EXPECT_TRUE(outcome.ok()) << "a tenth of the span is the limit";
  errors.delivered = 11;
  judge(errors, "temperature", "K", outcome);
  EXPECT_EQ(outcome.status, Status::inaccurate);
  EXPECT_NE(outcome.reason.find("11 times"), std::string::npos) << outcome.reason;
  errors.relative_rms = 0.2;
  judge(errors, "temperature", "K", outcome);
  EXPECT_NE(outcome.reason.find("20 %"), std::string::npos) << outcome.reason;
}

TEST(Judge, AnErrorThatTheReferenceMayHaveMadeIsNoVerdict) {
  // Ten times the tolerance is the limit: 1 here.
  EXPECT_DOUBLE_EQ(delivered_error(0.5, 0.4, 0.1).value(), 5) << "within the limit, however far it is off";
  EXPECT_DOUBLE_EQ(delivered_error(2, 0.9, 0.1).value(), 20) << "beyond it, however far it is off";
  EXPECT_FALSE(delivered_error(1.5, 0.9, 0.1)) << "the method may be right";
  EXPECT_FALSE(delivered_error(0, 5, 0.1)) << "the method may be as wrong as the reference";
}

class RodVerification : public testing::Test {
 protected:
  Verification of(const std::string& spec) {
    return verify(scene_, probes_, spec, &reference_, nullptr, nullptr);
  }

  CaseFolder folder_;
  Scene scene_ = load_scene(write_rod(folder_, Rod{}));
  ProbeSet probes_{scene_};
  Progress silent_{false};
  Reference reference_ =
      obtain_reference(scene_, probes_, {.spec = "cvode:rtol=1e-9"}, silent_).reference.value();
};

TEST_F(RodVerification, TheReferenceHasNoErrorAgainstItself) {
  const auto result = of("cvode:rtol=1e-9");
  ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
  EXPECT_EQ(result.errors[0].rms, 0);
  EXPECT_EQ(result.errors[0].probe_mean, 0);
  EXPECT_GT(result.errors[0].reference_error.value(), 0);
  EXPECT_LT(result.errors[0].reference_error.value(), 1e-5);  // of 10 K at rtol 1e-8
}

TEST_F(RodVerification, ForwardEulerErrorsAreProportionalToTheStep) {
  const auto coarse = of("forward-euler:step=0.2").errors[0], fine = of("forward-euler:step=0.1").errors[0];
  EXPECT_NEAR(*coarse.rms / *fine.rms, 2, 0.1);  // first order; 5 % for terms of higher order
  EXPECT_NEAR(*coarse.probe_mean / *fine.probe_mean, 2, 0.1);
  EXPECT_GE(*coarse.max, *coarse.rms);
  EXPECT_DOUBLE_EQ(*coarse.relative_rms, *coarse.rms / 10);
}

TEST_F(RodVerification, HeatIsBalancedAndStaysInRange) {
  const auto coarse = of("forward-euler:step=0.4").errors[0], fine = of("forward-euler:step=0.1").errors[0];
  EXPECT_EQ(coarse.overshoot, 0);
  // What entered comes from the reference: the balance shows the heat that a method has too much or too
  // little, which falls with the step, and is no identity of the method's own.
  EXPECT_GT(std::abs(coarse.balance.value()), 2 * std::abs(fine.balance.value()));
  EXPECT_LT(std::abs(coarse.balance.value()), 0.1);
  EXPECT_LT(std::abs(of("cvode:rtol=1e-9").errors[0].balance.value()), 1e-7);
}

TEST_F(RodVerification, AnUnstableRunHasAReasonAndNoErrors) {
  const auto result = of("forward-euler:step=0.7");
  EXPECT_EQ(result.outcome.status, Status::unstable);
  EXPECT_FALSE(result.outcome.reason.empty());
  EXPECT_TRUE(result.errors.empty());
}

TEST_F(RodVerification, WithoutAReferenceOvershootRemains) {
  const auto result = verify(scene_, probes_, "forward-euler", nullptr, nullptr, nullptr);
  ASSERT_TRUE(result.outcome.ok());
  EXPECT_FALSE(result.errors[0].rms);
  EXPECT_FALSE(result.errors[0].probe_mean);
  EXPECT_TRUE(result.errors[0].overshoot);
}

}  // namespace
}  // namespace superstep
