/// The work-precision sweep: every method on a ladder, and who wins where.

#include "bench/harness/work_precision.hpp"

#include <gtest/gtest.h>

#include <set>

#include "case/scene.hpp"
#include "core/text/options.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

WorkPrecisionPoint point(const std::string& spec, double cpu, double error) {
  WorkPrecisionPoint out;
  out.spec = spec;
  out.integrator = out.family = parse_spec(spec).name;
  out.status = "ok";
  out.cpu = Timing{cpu, cpu, cpu};
  out.worst = out.worst_relative = error;
  out.error_rms = {error};
  return out;
}

TEST(WorkPrecision, WinnerIsTheCheapestThatReachesTheLevel) {
  WorkPrecision study;
  study.output_times = {1};
  study.reference_error = 1e-6;
  study.span = 1;
  study.points = {point("forward-euler", 8, 5e-3), point("rkc:rtol=1e-2", 1, 2e-2),
                  point("rkc:rtol=1e-4", 2, 2e-4), point("exponential", 3, 1e-9), point("auto", 0.5, 1e-9)};
  auto failed = point("sts", 0.1, 0);
  failed.status = "unstable";
  failed.reason = "grew";
  study.points.push_back(failed);
  const auto levels = winners(study);
  ASSERT_EQ(levels.size(), 5u);  // 1e-1 to 1e-5: nothing is claimed below the error bar
  EXPECT_EQ(levels[0].winner->spec, "rkc:rtol=1e-2");
  EXPECT_EQ(levels[1].winner->spec, "rkc:rtol=1e-4");
  EXPECT_DOUBLE_EQ(*levels[1].lead, 1.5);
  EXPECT_DOUBLE_EQ(*levels[1].over_euler, 4.0);
  EXPECT_EQ(levels[3].winner->spec, "exponential");
  EXPECT_EQ(levels[3].runner_up, nullptr);
  EXPECT_FALSE(levels[3].over_euler) << "forward Euler does not reach it";
  EXPECT_NE(work_precision_table(study, false).find("Euler does not reach it"), std::string::npos);
  const auto csv = work_precision_csv(study);
  EXPECT_NE(csv.find("unstable,grew"), std::string::npos);  // failed points stay visible
  EXPECT_NE(work_precision_table(study, false).find("sts: unstable: grew"), std::string::npos);
}

TEST(WorkPrecision, NothingIsSaidOfAnEulerThatWasNotRun) {
  WorkPrecision study;
  study.output_times = {1};
  study.span = 1;
  study.points = {point("rkc:rtol=1e-4", 2, 2e-4)};
  const std::string table = work_precision_table(study, false);
  EXPECT_EQ(table.find("Euler does not reach it"), std::string::npos) << table;
  EXPECT_NE(table.find("Euler was not run"), std::string::npos) << table;
}

TEST(WorkPrecision, EveryMethodOfTheRegistryHasAValidLadder) {
  std::set<std::string> names;
  for (const auto& spec : work_precision_specs()) {
    EXPECT_NO_THROW(static_cast<void>(make_integrator(spec))) << spec;
    names.insert(parse_spec(spec).name);
  }
  EXPECT_EQ(names.size(), integrators().size());
}

WorkPrecision swept(const std::string& name, std::vector<std::string> specs) {
  Progress progress(false);
  WorkPrecisionOptions options;
  options.use_cache = false;
  options.repetitions = 2;
  options.integrators = std::move(specs);
  return work_precision(load_scene(std::string(SUPERSTEP_SOURCE_DIR) + "/cases/" + name + ".toml"), options,
                        progress);
}

TEST(WorkPrecision, SweepsACase) {
  const auto study =
      swept("chain", {"rkc:rtol=1e-3", "rkc:rtol=1e-6", "exponential", "forward-euler:step=0.6"});
  ASSERT_EQ(study.points.size(), 4u);
  EXPECT_LT(study.points[1].worst, 0.1 * study.points[0].worst);
  EXPECT_LT(study.points[2].worst_relative, 1e-7);
  EXPECT_EQ(study.points[3].status, "unstable");
  EXPECT_EQ(study.points[0].error_rms.size(), study.output_times.size());
  EXPECT_EQ(study.reference, "exponential:basis=chebyshev,rtol=1e-14");
}

TEST(WorkPrecision, WhatLeavesItsRangeWinsNothing) {
  const auto study = swept("lattice", {"sts:n=10,nu=1e-4", "sts:n=20,nu=1e-5"});
  EXPECT_EQ(study.points[0].status, "ok") << "its error, 11 %, stands beside it";
  EXPECT_EQ(study.points[1].status, "inaccurate");
  EXPECT_NE(study.points[1].reason.find("leaves the range"), std::string::npos) << study.points[1].reason;
  EXPECT_TRUE(study.points[1].cpu.has_value());
  EXPECT_EQ(study.points[1].error_rms.size(), study.output_times.size());
}

}  // namespace
}  // namespace superstep
