/// Super-time-stepping against its closed forms and the published counts.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "integrators/detail/driver/run_guard.hpp"
#include "integrators/registry.hpp"
#include "integrators/schemes/super_step.hpp"
#include "integrators/schemes/three_term.hpp"
#include "support/problem.hpp"

namespace superstep {
namespace {

struct PublishedCount {
  double nu;
  int n;
  std::uint64_t substeps;
};

std::uint64_t substeps(double t_end, double critical_step, int n, double nu) {
  return static_cast<std::uint64_t>(n) * steps_to_cover(t_end, critical_step * superstep_length(n, nu));
}

// Rojek & Nisar 2026, table 2: critical step 0.3 x 7.1663e-8 s, 1 ms.
TEST(PublishedSubsteps, ThermalTable2) {
  const PublishedCount table[] = {{1e-3, 5, 9610},  {1e-3, 10, 5260}, {1e-3, 15, 3990}, {1e-3, 20, 3460},
                                  {1e-3, 25, 3225}, {1e-4, 5, 9335},  {1e-4, 10, 4720}, {1e-4, 15, 3195},
                                  {1e-4, 20, 2460}, {1e-4, 25, 2025}, {1e-5, 5, 9310},  {1e-5, 10, 4660},
                                  {1e-5, 15, 3120}, {1e-5, 20, 2340}, {1e-5, 25, 1900}};
  for (const auto& row : table)
    EXPECT_EQ(substeps(1e-3, 2.1499e-8, row.n, row.nu), row.substeps) << row.n << ' ' << row.nu;
  EXPECT_NEAR(static_cast<double>(steps_to_cover(1e-3, 2.1499e-8)) / 46561, 1, 0.0011);
}

// Rojek & Nisar 2026, table 4: critical step 0.15 x 1.9424e-8 s, 4 ms.
TEST(PublishedSubsteps, ThermoelectricTable4) {
  const PublishedCount table[] = {{1e-3, 10, 155090}, {1e-3, 15, 117450}, {1e-3, 20, 101860},
                                  {1e-3, 25, 94500},  {1e-4, 10, 139110}, {1e-4, 15, 94260},
                                  {1e-4, 20, 72280},  {1e-4, 25, 59425},  {1e-5, 10, 137470},
                                  {1e-5, 15, 91800},  {1e-5, 20, 69020},  {1e-5, 25, 55375}};
  for (const auto& row : table)
    EXPECT_EQ(substeps(4e-3, 0.15 * 1.9424e-8, row.n, row.nu), row.substeps) << row.n << ' ' << row.nu;
  EXPECT_NEAR(static_cast<double>(steps_to_cover(4e-3, 0.15 * 1.9424e-8)) / 1374238, 1, 0.0011);
}

TEST(Superstep, ClosedFormIsTheSumOfSubsteps) {
  for (const int n : {1, 2, 7, 25, 128})
    for (const double nu : {1e-6, 1e-3, 0.05, 0.9}) {
      const auto taus = superstep_substeps(n, nu);
      const double sum = std::accumulate(taus.begin(), taus.end(), 0.0);
      EXPECT_NEAR(sum / superstep_length(n, nu), 1, 1e-10) << n << ' ' << nu;
    }
  EXPECT_NEAR(superstep_length(20, 1e-9), 400, 0.01);  // tends to n^2
}

TEST(Superstep, LejaOrderIsAPermutation) {
  auto natural = superstep_substeps(31, 1e-3), leja = leja_ordered(natural);
  EXPECT_NE(natural, leja);
  EXPECT_EQ(leja.front(), *std::min_element(natural.begin(), natural.end()));
  std::sort(natural.begin(), natural.end());
  std::sort(leja.begin(), leja.end());
  EXPECT_EQ(natural, leja);
}

TEST(Superstep, RecurrenceIsTheSamePolynomial) {
  for (const int n : {1, 2, 5, 20})
    for (const double nu : {1e-3, 0.05}) {
      ThreeTermScheme scheme;
      first_order_chebyshev(n, 2 * nu / (1 - nu), scheme);
      const auto taus = superstep_substeps(n, nu);
      const double length = superstep_length(n, nu);
      for (const double x : {0.0, 0.1, 0.5, 1.0, 1.7, 2.0}) {  // lambda * critical step
        double product = 1;
        for (const double tau : leja_ordered(taus)) product *= 1 - tau * x;
        const double z = -length * x;
        double before = 1, y = 1 + scheme.mt[1] * z;
        for (std::size_t j = 2; j <= static_cast<std::size_t>(n); ++j)
          before = std::exchange(y, scheme.m[j] * y + scheme.n[j] * before + scheme.mt[j] * z * y);
        EXPECT_NEAR(y, product, 1e-11)
            << n << ' ' << nu << ' ' << x;  // the product itself is good to n^2 roundings
      }
      EXPECT_NEAR(scheme.c[static_cast<std::size_t>(n)], 1, 1e-12);
      EXPECT_NEAR(scheme.beta, 2 * length, 1e-9 * length);
    }
}

TEST(Superstep, AllOrdersAgreeForFewSubsteps) {
  test::Problem problem(test::random_graph({.nodes = 40, .seed = 3}));
  const auto recurrence = test::run("sts:n=6,nu=0.01,order=recurrence", problem, {0.5, 1.3});
  for (const char* spec : {"sts:n=6,nu=0.01,order=leja", "sts:n=6,nu=0.01,order=natural"}) {
    const auto other = test::run(spec, problem, {0.5, 1.3});
    EXPECT_LT(test::max_difference(recurrence.states.back(), other.states.back()), 1e-11) << spec;
    EXPECT_EQ(other.sweeps, recurrence.sweeps);
  }
}

TEST(Superstep, ManySubstepsSurviveInTheSafeOrdersOnly) {
  // A chain, whose certified bound is sharp, and a rough start: the modes that natural order amplifies are
  // there.
  for (const std::string spec : {"sts:n=64,nu=0.05", "sts:n=128,nu=1e-3"}) {
    Graph graph = test::chain(300, 0.0, 1.0);
    for (std::size_t k = 0; k < graph.nodes(); ++k)
      graph.initial[k] = static_cast<double>(k * 7919 % 101) / 101;
    test::Problem problem(graph);
    const double t = 20000;
    const auto exact = problem.exact(t);
    for (const char* order : {",order=recurrence", ",order=leja"}) {
      const auto result = test::run(spec + order, problem, {t});
      ASSERT_TRUE(result.outcome.ok()) << spec << order << result.outcome.reason;
      EXPECT_LT(test::max_difference(result.states.back(), exact), 1e-4) << spec << order;
    }
    const auto natural = test::run(spec + ",order=natural", problem, {t});
    EXPECT_TRUE(natural.outcome.status == Status::unstable ||
                test::max_difference(natural.states.back(), exact) > 0.1)
        << spec << ": " << test::max_difference(natural.states.back(), exact);
  }
}

TEST(Superstep, AdaptsTheLastSuperstepToTheOutputTime) {
  test::Problem problem(test::chain(30, 0.0, 1.0));
  const double length = 0.45 * superstep_length(8, 0.01);
  const auto result = test::run("sts:n=8,nu=0.01,step=0.45", problem, {2.5 * length, 4 * length});
  EXPECT_EQ(result.statistics.steps, 5u);  // 3 to the first output (the last scaled), 2 more to the second
  EXPECT_EQ(result.sweeps, 40u);
}

TEST(FixedSteps, AboveTheLimitAreReportedUnstable) {
  test::Problem problem(test::chain(50, 0.0, 1.0));  // lambda_max just below 4: limit 0.5
  for (const char* spec :
       {"forward-euler:step=0.55", "sts:n=6,nu=1e-3,step=0.8", "sts:n=6,nu=1e-3,step=0.8,order=leja"}) {
    const auto result = test::run(spec, problem, {500.0});
    EXPECT_EQ(result.outcome.status, Status::unstable) << spec;
    EXPECT_NE(result.outcome.reason.find("smaller step"), std::string::npos) << result.outcome.reason;
  }
  EXPECT_TRUE(test::run("forward-euler:step=0.49", problem, {500.0}).outcome.ok());
}

TEST(Registry, RefusesBadParametersWithTheirRange) {
  for (const char* spec : {"sts:nu=0", "sts:nu=1", "sts:nu=-1", "sts:n=0", "sts:n=1.5", "sts:order=reverse",
                           "forward-euler:step=0", "forward-euler:alpha=-1", "forward-euler:step=1,alpha=1",
                           "cvode:rtol=0", "forward-eule", "sts:m=3"})
    EXPECT_THROW(static_cast<void>(make_integrator(spec)), UsageError) << spec;
}

}  // namespace
}  // namespace superstep
