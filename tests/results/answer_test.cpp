#include "results/answer.hpp"

#include <gtest/gtest.h>

#include "results/results_table.hpp"

namespace superstep {
namespace {

BenchRow row(const std::string& spec, double cpu, double error, double prepare = 0) {
  BenchRow out;
  out.spec = spec;
  const auto colon = spec.find(':');
  out.integrator = spec.substr(0, colon);
  out.params = colon == std::string::npos ? "" : spec.substr(colon + 1);
  out.status = "ok";
  out.repetitions = 3;
  out.cpu_stepping = Timing{.median = cpu, .min = 0.95 * cpu, .max = 1.05 * cpu};
  out.cpu_prepare = prepare;
  out.errors.relative_rms = error;
  return out;
}

BenchCase bench(std::vector<BenchRow> rows) {
  BenchCase out;
  out.name = "rod";
  out.unit = "K";
  out.baseline = "forward-euler";
  out.rows = std::move(rows);
  return out;
}

TEST(Answer, NamesTheFastestThatIsAccurateEnoughAndItsLead) {
  const auto one = bench({row("forward-euler", 8, 1e-4), row("sts:n=5", 0.5, 2e-2),
                          row("rkc:rtol=1e-4", 2, 5e-4), row("cvode:linsol=klu,rtol=1e-4", 4, 1e-5)});
  EXPECT_EQ(answer_text(one),
            "Fastest with an error below 0.1 % of the span: rkc:rtol=1e-4 takes 2 s of CPU, preparation "
            "included, 4 times faster than forward-euler and 2 times faster than "
            "cvode:linsol=klu,rtol=1e-4.");
}

TEST(Answer, CountsPreparation) {
  const auto one =
      bench({row("forward-euler", 8, 1e-4), row("exponential", 1, 1e-5, 5), row("rkc", 2, 5e-4)});
  EXPECT_EQ(fastest_within(one, 1e-3)->spec, "rkc");
}

TEST(Answer, TakesALooserErrorWhereNothingIsBetterAndSaysNothingWithoutErrors) {
  EXPECT_EQ(answer_text(bench({row("forward-euler", 8, 0.05), row("sts", 1, 0.5)})),
            "No method kept its error below 0.1 % of the span. Fastest with an error below 10 % of the "
            "span: forward-euler takes 8 s of CPU, preparation included.");
  EXPECT_EQ(answer_text(bench({row("forward-euler", 8, 0.5)})),
            "No method kept its error below 10 % of the span.");
  auto unmeasured = row("forward-euler", 8, 0);
  unmeasured.errors.relative_rms.reset();
  EXPECT_EQ(answer_text(bench({unmeasured})), "");
}

TEST(Answer, AFailedRunNeverWinsAndTheWorseFieldCounts) {
  auto failed = row("sts", 0.1, 1e-6);
  failed.status = "inaccurate";
  auto coupled = row("exponential", 0.2, 1e-6);
  coupled.potential = FieldErrors{};
  coupled.potential->relative_rms = 0.5;
  EXPECT_EQ(fastest_within(bench({failed, coupled, row("rkc", 2, 1e-4)}), 1e-3)->spec, "rkc");
}

TEST(Answer, SaysWhichCannotBeToldApart) {
  const auto text =
      answer_text(bench({row("exponential", 1, 1e-5), row("auto", 1.05, 1e-5), row("rkc", 2, 1e-4)}));
  EXPECT_NE(text.find("; auto cannot be told apart from it in this run."), std::string::npos) << text;
}

TEST(Answer, LeadsOverNobodyThatCannotBeToldApart) {
  const auto text = answer_text(bench({row("rkc", 1, 1e-5), row("forward-euler", 1.05, 1e-5)}));
  EXPECT_EQ(text.find("times faster"), std::string::npos) << text;
  EXPECT_NE(text.find("; forward-euler cannot be told apart from it"), std::string::npos) << text;
}

TEST(Answer, OneRepetitionTellsWhatIsClearlySlowerAlone) {
  auto best = row("rkc", 1, 1e-5), near = row("rock", 1.05, 1e-5), far = row("rkl", 1.2, 1e-5);
  for (auto* one : {&best, &near, &far}) {
    one->repetitions = 1;
    one->cpu_stepping->min = one->cpu_stepping->max = one->cpu_stepping->median;
  }
  EXPECT_EQ(answer_text(bench({best, near, far})),
            "Fastest with an error below 0.1 % of the span: rkc takes 1 s of CPU, preparation included; rock "
            "cannot be told apart from it in this run.");
}

TEST(Answer, AnInterruptedBenchHasTimedNothingRatherThanBeenInaccurate) {
  auto euler = row("forward-euler", 8, 1e-4), rkc = row("rkc", 2, 5e-3);
  euler.cpu_stepping.reset();
  EXPECT_EQ(
      answer_text(bench({euler, rkc})),
      "No method that kept its error below 0.1 % of the span was timed. Fastest with an error below 1 % "
      "of the span: rkc takes 2 s of CPU, preparation included.");
  rkc.cpu_stepping.reset();
  EXPECT_EQ(answer_text(bench({euler, rkc})), "No method was timed, so that none is the fastest.");
}

TEST(Answer, DoesNotClaimWhatTheReferenceCannotTell) {
  auto rkc = row("rkc", 2, 1e-5);
  rkc.errors.span = 100;
  rkc.errors.reference_error = 0.5;
  EXPECT_EQ(answer_text(bench({rkc})),
            "The reference cannot tell which method kept its error below 0.1 % of the span. Fastest with an "
            "error below 1 % of the span: rkc takes 2 s of CPU, preparation included.");
}

TEST(ResultsTable, IsSortedByCpuWithPreparationAndEndsInTheAnswer) {
  const auto one =
      bench({row("forward-euler", 8, 1e-4), row("exponential", 1, 1e-5, 5), row("rkc", 2, 5e-4)});
  const std::string text = results_table(one, 3, 1, false);
  const auto rkc = text.find("\nrkc "), exponential = text.find("\nexponential "),
             euler = text.find("\nforward-euler ");
  ASSERT_NE(rkc, std::string::npos) << text;
  EXPECT_LT(rkc, exponential);
  EXPECT_LT(exponential, euler);
  EXPECT_TRUE(text.ends_with(answer_text(one) + "\n"));
}

TEST(ResultsTable, SaysThatSpeedupsLeavePreparationOut) {
  auto exponential = row("exponential", 1, 1e-5, 5);
  exponential.speedup_stepping = 8;
  exponential.speedup_prepared = 1.333;
  const std::string text = results_table(bench({row("forward-euler", 8, 1e-4), exponential}), 3, 1, false);
  EXPECT_NE(text.find(" stepping  theory "), std::string::npos) << text;
}

TEST(ResultsTable, OneRepetitionHasNoSpread) {
  auto once = row("rkc", 2, 5e-4);
  once.repetitions = 1;
  once.cpu_stepping = Timing{.median = 2, .min = 2, .max = 2};
  const std::string text = results_table(bench({once}), 1, 1, false);
  EXPECT_EQ(text.substr(0, text.find("Fastest")).find('%'), std::string::npos) << text;
}

}  // namespace
}  // namespace superstep
