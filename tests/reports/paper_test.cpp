/// Published values beside ours: which of our runs is compared, and by which rule.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reports/html/like_for_like.hpp"
#include "reports/html/sections/paper_parts.hpp"
#include "sample_report.hpp"

namespace superstep {
namespace {

using test::sample_row;

bool has(const std::string& html, const std::string& part) {
  return html.find(part) != std::string::npos;
}

BenchCase thermoelectric() {
  BenchCase one;
  one.source = "Rojek & Nisar 2026, section 9.2";
  one.baseline = "forward-euler:alpha=0.15";
  one.unit = "K";
  one.rows = {sample_row("c", "sts", "n=10,nu=1e-3,alpha=0.15,heat=substep", 16),
              sample_row("c", "sts", "n=10,nu=1e-3,alpha=0.15", 10),
              sample_row("c", "sts", "n=20,nu=1e-4,alpha=0.15", 5),
              sample_row("c", "forward-euler", "alpha=0.15", 150)};
  for (auto& row : one.rows) row.potential = row.errors;
  const auto counts = [&](std::size_t row, std::uint64_t steps, std::uint64_t stages) {
    one.rows[row].steps = steps;
    one.rows[row].max_stages = stages;
  };
  counts(0, 100, 10);
  counts(1, 100, 10);
  counts(2, 25, 20);
  counts(3, 10'000, 1);
  return one;
}

TEST(Published, StatesHowItsErrorsWereTaken) {
  const auto thermal = published_case("Rojek & Nisar 2026, section 9.1").value();
  EXPECT_EQ(thermal.field, "temperature");
  EXPECT_EQ(thermal.measure.field, "temperature");
  EXPECT_TRUE(thermal.measure.as_written && thermal.rate_times_ln10);
  EXPECT_EQ(thermal.measure.every, 1e-5);
  EXPECT_EQ(thermal.measure.from, 2e-5);
  EXPECT_EQ(thermal.measure.to, 1e-3);
  const auto electric = published_measure("Rojek & Nisar 2026, section 9.2").value();
  EXPECT_EQ(electric.field, "potential");
  EXPECT_FALSE(electric.as_written);
  EXPECT_EQ(electric.from, 6e-5);
  EXPECT_EQ(electric.to, 4e-4);
  EXPECT_FALSE(published_measure("somebody else"));
}

TEST(OurRun, IsFoundByTheParametersOfItsSpec) {
  const BenchCase one = thermoelectric();
  EXPECT_EQ(our_run(one, PublishedRun()), &one.rows[3]) << "nu = 0 is forward Euler: the baseline";
  PublishedRun wanted;
  wanted.nu = 1e-3;
  wanted.n = 10;
  EXPECT_EQ(our_run(one, wanted), &one.rows[1]) << "not the one that evaluates the heat more often";
  EXPECT_EQ(our_run(one, wanted, /*heat_every_substep=*/true), &one.rows[0]);
  wanted.n = 20;
  EXPECT_EQ(our_run(one, wanted), nullptr) << "n = 20 was run with another nu";
  wanted.nu = 1e-4;
  EXPECT_EQ(our_run(one, wanted), &one.rows[2]);
  EXPECT_EQ(our_run(one, wanted, /*heat_every_substep=*/true), nullptr);
}

TEST(LikeForLike, CountsTheEvaluationsThatAreMissing) {
  const BenchCase one = thermoelectric();
  EXPECT_EQ(substeps(one.rows[1]), 1000);
  const double cost = 5e-3;  // s
  const LikeForLike speedup = like_for_like(one.rows[3], one.rows[1], cost);
  // 1000 substeps, 100 of which evaluate the heat: 900 more; forward Euler 9900 fewer.
  EXPECT_DOUBLE_EQ(speedup.every_substep.value(), 150 / (10 + 900 * cost));
  EXPECT_DOUBLE_EQ(speedup.every_superstep.value(), (150 - 9900 * cost) / 10);
}

TEST(LikeForLike, OfEqualWorkIsTheRatioOfSubsteps) {
  // A substep of both fields costs 10 ms, the heat 5 ms: forward Euler takes 15 ms a step.
  BenchRow euler = thermoelectric().rows[3], sts = thermoelectric().rows[1];
  const double sweep = 10e-3, cost = 5e-3;
  euler.cpu_stepping = Timing{10'000 * (sweep + cost), 0, 0};
  sts.cpu_stepping = Timing{1000 * sweep + 100 * cost, 0, 0};
  const LikeForLike speedup = like_for_like(euler, sts, cost);
  EXPECT_DOUBLE_EQ(speedup.every_substep.value(), 10);
  // Forward Euler would evaluate it 100 times, too: once in 100 of its steps, not once in 10.
  EXPECT_DOUBLE_EQ(speedup.every_superstep.value(),
                   (10'000 * sweep + 100 * cost) / (1000 * sweep + 100 * cost));
}

TEST(LikeForLike, IsEmptyWithoutTimesOrCounts) {
  BenchRow euler = thermoelectric().rows[3], sts = thermoelectric().rows[1];
  sts.cpu_stepping.reset();
  EXPECT_FALSE(like_for_like(euler, sts, 1e-3).every_substep);
  sts = thermoelectric().rows[1];
  sts.max_stages.reset();
  EXPECT_FALSE(like_for_like(euler, sts, 1e-3).every_superstep);
  // A cost that exceeds what forward Euler took is no cost.
  EXPECT_FALSE(like_for_like(euler, thermoelectric().rows[1], 1.0).every_superstep);
}

TEST(PaperPerformance, ComparesSubstepsAndPutsTheHeatOnOneFooting) {
  BenchCase one = thermoelectric();
  one.cpu_joule = 5e-3;
  one.rows[0].speedup_stepping = 9.375;  // 150 s over 16 s
  const auto published = published_case(one.source).value();
  const std::string html = paper_performance(one, published);
  EXPECT_TRUE(has(html, "10000")) << "substeps of forward Euler, not sweeps over both fields";
  EXPECT_TRUE(has(html, "9.38")) << "what was measured with heat=substep goes first";
  EXPECT_TRUE(has(html, "20.3")) << "150 / (5 + 475 * 5e-3) for the run that has no such twin";
  EXPECT_TRUE(has(html, "5000 µs each"));
  for (auto& row : one.rows) row.potential.reset();
  EXPECT_FALSE(has(paper_performance(one, published), "heat")) << "one field: no heat, no such columns";
}

class PaperErrors : public testing::Test {
 protected:
  PaperErrors() {
    one_.source = "Rojek & Nisar 2026, section 9.1";
    one_.baseline = "forward-euler:alpha=0.3";
    one_.rows = {sample_row("c", "sts", "n=10,nu=1e-3,alpha=0.3", 1)};
    one_.rows[0].errors.published_mean = 8.1e-3;
    one_.rows[0].errors.published_rate = 3200;
    one_.rows[0].errors.published_r2 = 0.71;
  }
  [[nodiscard]] std::string html(const Number& lambda_min) const {
    return paper_errors(one_, published_case(one_.source).value(), {"temperature", "K", false}, lambda_min);
  }
  BenchCase one_;
};

TEST_F(PaperErrors, ShowBothReadingsOfTheDecayRate) {
  const std::string text = html(5012.4);
  EXPECT_TRUE(has(text, "8245")) << "as printed";
  EXPECT_TRUE(has(text, "3581")) << "over ln 10";
  EXPECT_TRUE(has(text, "0.894")) << "ours over that";
  EXPECT_TRUE(has(text, "0.0081")) << "the mean by the published rule";
  EXPECT_TRUE(has(text, "0.001<")) << "the true mean of the sample row";
  EXPECT_TRUE(has(text, "every 10 µs from 20 µs to 1 ms"));
  EXPECT_TRUE(has(text, "5012 1/s"));
}

TEST_F(PaperErrors, SayNothingAboutALambdaMinThatIsNotKnown) {
  EXPECT_TRUE(has(html(std::nullopt), "ln 10 times too large"));
  EXPECT_FALSE(has(html(std::nullopt), "slowest rate"));
  EXPECT_FALSE(has(html(1e5), "slowest rate")) << "a rate below it contradicts nothing";
}

TEST_F(PaperErrors, OfResultsWithoutThePublishedRuleShowTheTrueOnes) {
  one_.rows[0].errors.published_mean = one_.rows[0].errors.published_rate = std::nullopt;
  const std::string text = html(5012.4);
  EXPECT_TRUE(has(text, "0.001<"));
  EXPECT_FALSE(has(text, "ln 10 times too large")) << "there is nothing of ours to say it by";
}

}  // namespace
}  // namespace superstep
