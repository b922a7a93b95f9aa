/// Errors by the rule of a published table, on histories whose answers are known.

#include "bench/measure/sampled_errors.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "bench/harness/harness.hpp"
#include "bench/harness/verification.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

using test::CaseFolder;
using test::Rod;

/// A code that steps by `step` from 0 to `last` over value(t).
template <class Value>
ProbeHistory history_of(double step, double last, const Value& value) {
  ProbeHistory history(1);
  for (int k = 0; k * step < last + 0.5 * step; ++k) history.append(k * step, std::array{value(k * step)});
  return history;
}

std::vector<double> written(const ProbeHistory& history, const std::vector<double>& instants) {
  return written_values(history, 0, instants, /*rounding=*/1e-9);
}

/// A difference of two values of that size is known to a few of their roundings.
double rounding_of(double size) {
  return 4 * std::numeric_limits<double>::epsilon() * size;
}

TEST(SampledErrors, InstantsIncludeBothEnds) {
  EXPECT_EQ(sampling_instants({.field = "temperature", .every = 0.5, .from = 1, .to = 3}),
            (std::vector<double>{1, 1.5, 2, 2.5, 3}));
  const auto paper = sampling_instants({.field = "temperature", .every = 1e-5, .from = 2e-5, .to = 1e-3});
  ASSERT_EQ(paper.size(), 99U) << "the count does not suffer from the rounding of 1e-5";
  EXPECT_NEAR(paper.back(), 1e-3, 1e-18);
}

TEST(SampledErrors, WrittenIsTheFirstStepEndAtOrAfterTheInstant) {
  const auto history = history_of(0.75, 6, [](double t) { return 10 * t; });  // ends at 0, 0.75, 1.5, ...
  EXPECT_EQ(written(history, {1, 1.5, 1.6, 4}), (std::vector<double>{15, 15, 22.5, 45}));
}

TEST(SampledErrors, AStepEndThatMissesTheInstantByRoundingIsAtIt) {
  ProbeHistory history(1);
  for (const double t : {0.0, 1 - 1e-12, 2.0}) history.append(t, std::array{t});
  EXPECT_EQ(written(history, {1}).front(), 1 - 1e-12);
}

TEST(SampledErrors, AHistoryThatEndsEarlyHasNoSamples) {
  const auto history = history_of(1, 3, [](double t) { return t; });
  EXPECT_FALSE(written(history, {1, 3}).empty());
  EXPECT_TRUE(written(history, {1, 3.5}).empty());
  EXPECT_TRUE(values_at(history, 0, std::array{1.0, 3.5}, 1e-9).empty());
  EXPECT_TRUE(written(ProbeHistory(1), {1}).empty());
}

TEST(SampledErrors, ValuesAtTheInstantsAreInterpolated) {
  const auto history = history_of(2, 6, [](double t) { return 10 * t; });
  EXPECT_EQ(values_at(history, 0, std::array{1.0, 2.0, 5.5}, 1e-9), (std::vector<double>{10, 20, 55}));
}

/// Two codes without any error that write at their own step ends: what is subtracted is the part of a step by
/// which one writes later, and it decays as the rate of change does.
class Writing : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Offsets, Writing, testing::Values(0.0, 300.0));

TEST_P(Writing, WithoutAnyErrorTheLagIsMeasured) {
  const double offset = GetParam(), rate = 0.5;
  const auto exact = [&](double t) { return offset + 10 * (1 - std::exp(-rate * t)); };
  const auto coarse = history_of(0.4, 8, exact), fine = history_of(0.25, 8, exact);
  // Instants 1, 2, 3, 4: the coarse code writes at 1.2, 2, 3.2, 4; the fine one at the instants.
  const std::vector<double> instants = {1, 2, 3, 4};
  FieldErrors errors;
  measure_samples(instants, written(coarse, instants), written(fine, instants), errors);
  const double lag = 1 - std::exp(-rate * 0.2);
  const double expected = 10 * lag * (std::exp(-rate * 1) + std::exp(-rate * 3)) / 4;
  EXPECT_NEAR(errors.published_mean.value(), expected, rounding_of(offset + 10));
  // At the instants themselves nothing differs but by rounding and by the straight line between step ends.
  FieldErrors none;
  measure_samples(instants, values_at(coarse, 0, instants, 1e-9), values_at(fine, 0, instants, 1e-9), none);
  EXPECT_LT(*none.published_mean, 10 * rate * rate * 0.4 * 0.4 / 8);  // h^2/8 of the curvature
}

TEST_P(Writing, TheDecayIsThatOfTheDifference) {
  const double offset = GetParam(), rate = 0.5;
  const auto exact = [&](double t) { return offset + 10 * (1 - std::exp(-rate * t)); };
  const auto wrong = [&](double t) { return exact(t) + 0.1 * std::exp(-rate * t); };
  const std::vector<double> instants = {1, 2, 3, 4, 5, 6, 7, 8};
  FieldErrors errors;
  measure_samples(instants, written(history_of(1, 8, wrong), instants),
                  written(history_of(1, 8, exact), instants), errors);
  // The smallest difference, 0.1 exp(-4) = 2e-3, carries the rounding of 310: some 1e-10 of it.
  EXPECT_NEAR(errors.published_rate.value(), rate, 1e-9);
  EXPECT_NEAR(errors.published_r2.value(), 1, 1e-9);
}

TEST_P(Writing, TrueErrorsDoNotSeeTheOffset) {
  const double offset = GetParam();
  const auto exact = [&](double t) { return offset + 8 * std::exp(-t); };
  const auto wrong = [&](double t) { return exact(t) + 0.5 * std::exp(-t); };
  FieldErrors errors;
  measure_probe_errors(history_of(0.5, 10, wrong), history_of(0.5, 10, exact), 0, 10, errors);
  // The transient: step ends at which the reference is more than 1 % away from its end, t = 0.5 ... 4.5; the
  // initial state is no step end.
  double sum = 0;
  for (int k = 1; k <= 9; ++k) sum += 0.5 * std::exp(-0.5 * k);
  EXPECT_NEAR(errors.probe_mean.value(), sum / 9, rounding_of(offset + 8));
  EXPECT_NEAR(errors.decay_rate.value(), 1, 1e-9);  // as above
}

class PublishedRod : public testing::Test {
 protected:
  BenchCase bench(const SampledMeasure& measure) {
    HarnessOptions options{.integrators = {"sts:n=5,nu=0.05"},
                           .reference = "",
                           .use_cache = false,
                           .repetitions = 1,
                           .sampled = measure};
    return bench_case(scene_, 0, options, silent_);
  }
  ProbeHistory history(const std::string& spec) {
    return verify(scene_, probes_, spec, nullptr, nullptr, nullptr).history;
  }
  CaseFolder folder_;
  Scene scene_ = load_scene(write_rod(folder_, Rod{}));
  ProbeSet probes_{scene_};
  Progress silent_{false};
};

TEST_F(PublishedRod, SubtractsTheBaselineThatIsVerifiedLast) {
  const SampledMeasure measure{.field = "temperature", .every = 3, .from = 3, .to = 60, .as_written = true};
  const BenchCase one = bench(measure);
  ASSERT_EQ(one.rows.size(), 2U);
  ASSERT_EQ(one.rows[1].spec, one.baseline);
  const auto instants = sampling_instants(measure);
  FieldErrors expected;
  measure_samples(instants, written(history(one.rows[0].spec), instants),
                  written(history(one.baseline), instants), expected);
  ASSERT_TRUE(one.rows[0].errors.published_mean);
  EXPECT_EQ(one.rows[0].errors.published_mean, expected.published_mean);
  EXPECT_EQ(one.rows[0].errors.published_rate, expected.published_rate);
  EXPECT_EQ(one.rows[0].errors.published_r2, expected.published_r2);
  EXPECT_FALSE(one.rows[1].errors.published_mean) << "against itself there is nothing to see";
  ASSERT_TRUE(one.sampled);
  EXPECT_EQ(one.sampled->every, 3);
}

TEST_F(PublishedRod, TrueErrorsAreAgainstTheReferenceForEveryMethod) {
  const BenchCase one = bench({.field = "temperature", .every = 3, .from = 3, .to = 60, .as_written = false});
  for (const auto& row : one.rows) {
    ASSERT_TRUE(row.errors.published_mean) << row.spec;
    EXPECT_GT(*row.errors.published_mean, 0) << row.spec;
    EXPECT_LE(*row.errors.published_mean, 10) << row.spec << ": the span";
  }
}

TEST_F(PublishedRod, AWindowBeyondTheEndIsNotMeasured) {
  const BenchCase one = bench({.field = "temperature", .every = 3, .from = 3, .to = 120, .as_written = true});
  for (const auto& row : one.rows) {
    EXPECT_EQ(row.status, "ok");
    EXPECT_FALSE(row.errors.published_mean);
  }
}

TEST_F(PublishedRod, AnotherFieldIsNotMeasured) {
  const BenchCase one = bench({.field = "potential", .every = 3, .from = 3, .to = 60, .as_written = true});
  for (const auto& row : one.rows) EXPECT_FALSE(row.errors.published_mean);
}

}  // namespace
}  // namespace superstep
