/// superstep fit: constants are found again, outliers and the class that is held out have no say in them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "bench/app/cli/run_program.hpp"
#include "bench/harness/corpus/cost_fit.hpp"
#include "core/median.hpp"
#include "results/corpus/corpus_csv.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

/// Constants of another machine, and of methods that work otherwise.
CostConstants others() {
  CostConstants out;
  double factor = 1.5;
  for (const auto& one : cost_constants()) out.*one.value *= factor = factor > 1 ? 1 / factor : 1.5;
  return out;
}

/// What a corpus would find where costs are exactly as predicted.
std::vector<CorpusRow> rows_of(const CostConstants& constants) {
  std::vector<CorpusRow> rows;
  for (const char* physics : {"linear", "one-way", "nonlinear", "coupled"})
    for (const double unknowns : {100.0, 1'000.0, 30'000.0})
      for (const double t_rho : {1e3, 1e5, 1e7}) {
        CorpusRow scene;
        scene.scene = fmt::format("{}-{}-{}", physics, unknowns, t_rho);
        scene.scene_class = physics;
        scene.physics = physics;
        scene.unknowns = static_cast<std::uint64_t>(unknowns);
        scene.nonzeros = scene.unknowns * (unknowns == 1'000.0 ? 2 : 6);
        scene.stiffness = t_rho;
        scene.status = "ok";
        scene.reference_error = 1e-13;
        const Work work = work_of(scene);
        for (const auto& candidate : candidates(work, 1e-4, constants))
          for (const double rtol : {1e-2, 1e-4, 1e-6, 1e-8}) {
            CorpusRow row = scene;
            row.spec = family_spec(candidate.family, work.physics);
            row.spec +=
                fmt::format("{}rtol={:.0e}", row.spec.find(':') == std::string::npos ? ":" : ",", rtol);
            row.integrator = row.spec.substr(0, row.spec.find(':'));
            row.params = row.spec.substr(row.spec.find(':') + 1);
            const double seconds = predicted_seconds(candidate.family, work, rtol, constants);
            if (!std::isfinite(seconds)) continue;
            row.cpu = seconds;
            row.error = rtol / 4;
            rows.push_back(row);
          }
      }
  return rows;
}

double worst_factor(const std::vector<CorpusRow>& rows, const CostConstants& fitted) {
  double worst = 1;
  for (const auto& quality : fit_quality(cost_points(rows), fitted)) worst = std::max(worst, quality.worst);
  return worst;
}

TEST(Fit, PredictsWhatItHasSeen) {
  const auto rows = rows_of(others());
  const CostConstants fitted = fit_costs(cost_points(rows));
  EXPECT_GT(worst_factor(rows, {}), 1.3);      // it has something to find
  EXPECT_LT(worst_factor(rows, fitted), 1.1);  // the pull towards the constants without measurements remains
}

TEST(Fit, LetsOutliersBe) {
  const auto rows = rows_of(others());
  auto disturbed = rows;
  for (std::size_t k = 0; k < disturbed.size(); k += 20) *disturbed[k].cpu *= 1000;  // 5 % of them
  std::vector<double> off;
  const CostConstants fitted = fit_costs(cost_points(disturbed));
  for (const auto& quality : fit_quality(cost_points(rows), fitted)) off.push_back(quality.median);
  EXPECT_LT(median_of(off),
            1.25);  // without weights a thousand in twenty moves the logarithm of all by 0.35: 1.4
}

TEST(Fit, ChoosesWithoutTheClassThatIsHeldOut) {
  auto rows = rows_of(others());
  const auto choices = held_out_choices(rows, cost_points(rows));
  for (auto& row : rows)  // exprb becomes the fastest of all, there alone
    if (row.scene_class == "coupled" && row.integrator == "exprb") *row.cpu *= 1e-3;
  const auto disturbed = held_out_choices(rows, cost_points(rows));
  ASSERT_EQ(choices.size(), disturbed.size());
  std::size_t beyond = 0;
  for (std::size_t k = 0; k < choices.size(); ++k) {
    if (choices[k].facts->scene_class != "coupled") continue;
    EXPECT_EQ(choices[k].spec, disturbed[k].spec);
    if (disturbed[k].choice.family != Family::exprb) beyond += !disturbed[k].within(2);
  }
  EXPECT_GT(beyond, 0u);
}

TEST(Fit, RegretsAChoiceThatDidNotEndWell) {
  auto rows = rows_of({});
  std::erase_if(rows,
                [](const CorpusRow& row) { return row.physics == "nonlinear" && row.integrator == "rock"; });
  bool seen = false;
  for (const auto& one : held_out_choices(rows, cost_points(rows)))
    if (one.facts->physics == "nonlinear" && one.choice.family == Family::rock) {
      seen = true;
      EXPECT_TRUE(std::isinf(one.ratio()));
      EXPECT_FALSE(one.within(2));
    }
  EXPECT_TRUE(seen);
}

TEST(Fit, WritesTheHeaderThatTheBuildTakes) {
  test::CaseFolder folder;
  folder.write("corpus.csv", corpus_csv(rows_of(others())));
  testing::internal::CaptureStdout();
  ASSERT_EQ(run_program({"fit", folder.file("corpus.csv"), "--quiet", "--out", folder.file("constants.hpp")}),
            0);
  const std::string table = testing::internal::GetCapturedStdout();
  EXPECT_NE(table.find("within 1.3 in"), std::string::npos) << table;
  const std::string header = folder.read("constants.hpp");
  for (const auto& one : cost_constants())
    EXPECT_NE(header.find(fmt::format("c.{} = ", one.name)), std::string::npos) << one.name;
  EXPECT_NE(header.find("superstep fit "), std::string::npos);
}

TEST(Fit, CountsAMeasurementOnceAndNamesEveryFamily) {
  test::CaseFolder folder;
  auto rows = rows_of(others());
  CorpusRow euler = rows.front();
  euler.integrator = "forward-euler";
  euler.params = "fraction=1";
  euler.spec = "forward-euler:fraction=1";
  euler.steps = euler.sweeps = 1000;
  rows.push_back(euler);
  folder.write("corpus.csv", corpus_csv(rows));
  const auto table_of = [&](std::vector<std::string> line) {
    testing::internal::CaptureStdout();
    EXPECT_EQ(run_program(line), 0);
    return testing::internal::GetCapturedStdout();
  };
  const std::string file = folder.file("corpus.csv");
  const std::string once = table_of({"fit", file, "--quiet"});
  EXPECT_EQ(once, table_of({"fit", file, file, "--quiet"}));
  EXPECT_NE(once.find("\nforward-euler "), std::string::npos) << once;
}

TEST(Fit, SaysWhatItCannotUse) {
  test::CaseFolder folder;
  EXPECT_EQ(run_program({"fit"}), 2);
  EXPECT_EQ(run_program({"fit", folder.file("nothing.csv")}), 3);
  auto rows = rows_of({});
  for (auto& row : rows) row.physics.clear();  // as of a version before
  folder.write("corpus.csv", corpus_csv(rows));
  EXPECT_EQ(run_program({"fit", folder.file("corpus.csv"), "--quiet"}), 6);
  for (auto& row : rows) row.physics = "magic";
  folder.write("corpus.csv", corpus_csv(rows));
  EXPECT_EQ(run_program({"fit", folder.file("corpus.csv"), "--quiet"}), 3);
}

}  // namespace
}  // namespace superstep
