/// What every integrator owes, run over the registry: a method that stands there is tested here.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "integrators/registry.hpp"
#include "support/problem.hpp"

namespace superstep {
namespace {

using test::max_difference;
using test::Problem;
using test::random_graph;
using test::rms_difference;
using test::run;

std::vector<std::string> all_specs() {
  std::vector<std::string> specs;
  for (const auto& entry : integrators()) {
    specs.push_back(entry.name);
    specs.insert(specs.end(), entry.examples.begin(), entry.examples.end());
  }
  return specs;
}

/// Methods that iterate end where their iteration ends: exact relations hold to its tolerance, not to
/// rounding.
double exactness(const std::string& spec) {
  // The finish of a ROCK4 step multiplies roundings by up to 1e-5 s^8, kept below a tenth of the tolerance.
  if (spec.starts_with("rock")) return 1e-9;
  // Explicit steps at the limit of stability: their sizes, and so the errors, hang on the last bits.
  if (spec.starts_with("arkode") && spec.find("erk") != std::string::npos) return 1e-7;
  // PETSc solves by iterations unless told otherwise, and forms the coefficients of BDF by differences of
  // times.
  if (spec.starts_with("petsc")) return spec.find("linsol=lu") == std::string::npos ? 1e-7 : 1e-11;
  for (const char* iteration : {"pcg", "gmres", "fixed-point"})
    if (spec.find(iteration) != std::string::npos) return 1e-7;
  return 1e-12;
}

class EveryIntegrator : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (GetParam().find("linsol=hypre") == std::string::npos) return;
    Problem problem(test::chain(5, 0.0, 1.0));  // PETSc may have been built without it
    const auto outcome = run(GetParam(), problem, {1.0}).outcome;
    if (outcome.status == Status::refused) GTEST_SKIP() << outcome.reason;
  }
};

INSTANTIATE_TEST_SUITE_P(Registry, EveryIntegrator, ::testing::ValuesIn(all_specs()), [](const auto& spec) {
  std::string name = spec.param;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
});

TEST_P(EveryIntegrator, FindsTheExactAnswer) {
  // A chain relaxes 4000 times slower than its stiffest mode: room for long steps and supersteps.
  Problem problem(test::chain(100, 0.0, 1.0));
  const auto result = run(GetParam(), problem, {300, 1000, 3000});
  ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
  // The loosest spec takes first-order supersteps of a tenth of the relaxation time.
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_LT(rms_difference(result.states[k], problem.exact(std::vector{300., 1000., 3000.}[k])), 2e-2) << k;
}

TEST_P(EveryIntegrator, HitsOutputTimesExactly) {
  Problem problem(random_graph({.nodes = 20, .seed = 1}));
  Plan plan = problem.plan({0.1, 0.37, 1.0 / 3.0 + 0.4});
  const auto integrator = make_integrator(GetParam());
  integrator->prepare(*problem.rhs, plan);
  integrator->start(0, problem.initial);
  for (const double t : plan.output_times) {
    ASSERT_TRUE(integrator->advance(t).ok());
    EXPECT_EQ(integrator->time(), t);
  }
}

TEST_P(EveryIntegrator, ConservesHeatInAClosedNetwork) {
  Problem problem(random_graph({.nodes = 50, .seed = 11, .contrast = 100, .fixed = 0}));
  const auto result = run(GetParam(), problem, {0.5, 2.0});
  ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
  const auto heat = [&](const std::vector<double>& y) {
    double sum = 0;
    for (std::size_t k = 0; k < y.size(); ++k) sum += problem.rhs->capacities()[k] * y[k];
    return sum;
  };
  EXPECT_NEAR(heat(result.states.back()) / heat(problem.initial), 1.0, exactness(GetParam()));
}

TEST_P(EveryIntegrator, StoresWhatConstantSourcesBringIn) {
  Problem problem(random_graph({.nodes = 50, .seed = 12, .fixed = 0, .sources = true}));
  const auto result = run(GetParam(), problem, {0.5, 2.0});
  ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
  double stored = 0, supplied = 0;
  for (std::size_t k = 0; k < problem.initial.size(); ++k)
    stored += problem.rhs->capacities()[k] * (result.states.back()[k] - problem.initial[k]);
  for (const double source : problem.rhs->network().source) supplied += 2.0 * source;
  // Expansions keep heat to their tolerance, 1e-4 with auto.
  const bool expands = GetParam().starts_with("exp") || GetParam().starts_with("auto");
  EXPECT_NEAR(stored / supplied, 1.0, expands ? 1e-4 : 10 * exactness(GetParam()));
}

TEST_P(EveryIntegrator, LeavesAUniformStateAlone) {
  Graph graph = random_graph({.nodes = 40, .seed = 5, .contrast = 1e4});
  graph.initial.assign(graph.nodes(), 0.7);
  graph.fixed_value.assign(graph.nodes(), 0.7);
  Problem problem(graph);
  const auto result = run(GetParam(), problem, {1.0});
  ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
  for (const double value : result.states.back())
    EXPECT_NEAR(value, 0.7, 1e-12);  // some hundred stages of rounding
}

TEST_P(EveryIntegrator, DoesNotCareHowNodesAreNumbered) {
  const Graph graph = random_graph({.nodes = 120, .seed = 21, .contrast = 50, .fixed = 2, .sources = true});
  Problem problem(graph), shuffled(test::relabelled(graph, 99));
  const auto a = run(GetParam(), problem, {0.4, 1.5}), b = run(GetParam(), shuffled, {0.4, 1.5});
  ASSERT_TRUE(a.outcome.ok() && b.outcome.ok());
  const auto one = problem.by_id(a.states.back()), other = shuffled.by_id(b.states.back());
  const bool krylov = GetParam().starts_with("auto") || GetParam().starts_with("exp");
  if (krylov)  // ends where its tolerance is met, and rounding may decide on one vector more: each is within
               // it
    EXPECT_LT(test::rms_difference(one, other),
              std::max(2 * make_method(GetParam())->rtol(), exactness(GetParam())));
  else
    EXPECT_LT(max_difference(one, other), exactness(GetParam()));
}

TEST_P(EveryIntegrator, StartsAnewWithTheSameResult) {
  Problem problem(random_graph({.nodes = 30, .seed = 31, .sources = true}));
  const auto integrator = make_integrator(GetParam());
  integrator->prepare(*problem.rhs, problem.plan({0.5, 1.0}));
  std::vector<std::vector<double>> ends;
  for (int round = 0; round < 2; ++round) {
    integrator->start(0, problem.initial);
    ASSERT_TRUE(integrator->advance(0.5).ok());
    ASSERT_TRUE(integrator->advance(1.0).ok());
    ends.emplace_back(integrator->state().begin(), integrator->state().end());
  }
  EXPECT_LT(max_difference(ends[0], ends[1]), 1e-13);
}

TEST_P(EveryIntegrator, RecordsItsHistoryUpToTheEnd) {
  Problem problem(random_graph({.nodes = 30, .seed = 41}));
  const auto result = run(GetParam(), problem, {0.5, 1.0});
  ASSERT_GE(result.history.size(), 2u);
  EXPECT_GE(result.history.time(result.history.size() - 1), 1.0);
  for (std::size_t k = 1; k < result.history.size(); ++k)
    EXPECT_GT(result.history.time(k), result.history.time(k - 1));
  EXPECT_NEAR(result.history.at(1.0, 0), result.states.back()[0], 1e-12);
}

TEST_P(EveryIntegrator, StopsWhenAsked) {
  Problem problem(random_graph({.nodes = 30, .seed = 43}));
  std::atomic<bool> stop = true;
  Plan plan = problem.plan({100.0});
  plan.stop = &stop;
  const auto integrator = make_integrator(GetParam());
  integrator->prepare(*problem.rhs, plan);
  integrator->start(0, problem.initial);
  EXPECT_EQ(integrator->advance(100.0).status, Status::interrupted);
}

/// Who stops it comes too late: what was asked for is there.
TEST(Stopping, ARunThatHasComeToItsEndIsDone) {
  Problem problem(random_graph({.nodes = 30, .seed = 43}));
  const std::atomic<bool> stop = true;
  const auto first_step = [&](const std::vector<double>& output_times) {
    Plan plan = problem.plan(output_times);
    plan.stop = &stop;
    const auto integrator = make_integrator("forward-euler:step=1e-3");
    integrator->prepare(*problem.rhs, plan);
    integrator->start(0, problem.initial);
    return integrator->advance(output_times.front()).status;
  };
  EXPECT_EQ(first_step({1e-3}), Status::ok);
  EXPECT_EQ(first_step({1e-3, 2e-3}), Status::interrupted);
}

TEST(Watching, SteppingMethodsTellHowFarTheyHaveCome) {
  for (const char* spec : {"forward-euler", "sts", "rkc", "rkl", "rkg", "rock", "trapezoidal", "cvode"}) {
    Problem problem(random_graph({.nodes = 30, .seed = 43}));
    std::atomic<double> reached = -1;
    Plan plan = problem.plan({2.0, 3.0});
    plan.reached = &reached;
    const auto integrator = make_integrator(spec);
    integrator->prepare(*problem.rhs, plan);
    integrator->start(0, problem.initial);
    ASSERT_TRUE(integrator->advance(2.0).ok());
    EXPECT_GT(reached, 1.0) << spec;  // within an output, not only at its end; some ask every few steps
  }
}

TEST_P(EveryIntegrator, TreatsNodesWithoutNeighbours) {
  Graph graph = test::chain(5, 0.0, 1.0);
  graph.conductance.assign(graph.edges(), 0.0);
  graph.source[2] = 0.5;
  Problem problem(graph);
  const auto result = run(GetParam(), problem, {2.0});
  ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
  const auto row = static_cast<std::size_t>(problem.rhs->network().row_of_node[2]);
  EXPECT_NEAR(result.states.back()[row], 1.0, 1e-9);  // 0.5 W into 1 J/K for 2 s
}

TEST_P(EveryIntegrator, SolvesAStarInLinearTime) {
  if (GetParam().find(":step=") != std::string::npos)
    GTEST_SKIP() << "its fixed step is made for another network";
  constexpr std::size_t leaves = 100'000;
  Problem problem(test::star(leaves));
  const auto result = run(GetParam(), problem, {0.05});
  ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
  // Hub and leaves: their difference decays with rate leaves + 1 and is long gone; the mean stays.
  const auto hub = static_cast<std::size_t>(problem.rhs->network().row_of_node[0]);
  // A tolerance is one of the rms: a single node among so many may err by some hundred times more.
  EXPECT_NEAR(result.states.back()[hub], 1.0 / (leaves + 1),
              2e-2);  // a lightly damped superstep keeps some of it
}

TEST(CapacityContrast, SixDecadesAndShuffledIds) {
  for (const auto& spec : {"forward-euler", "sts:n=10,nu=0.05", "cvode:rtol=1e-8"}) {
    Graph graph = random_graph({.nodes = 60, .seed = 77, .contrast = 1e6, .fixed = 2});
    for (std::size_t k = 0; k < graph.nodes(); ++k) graph.id[k] = 1000 - 37 * static_cast<std::int64_t>(k);
    Problem problem(test::relabelled(graph, 5));
    const auto result = run(spec, problem, {1e-3});
    ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
    EXPECT_LT(rms_difference(result.states.back(), problem.exact(1e-3)), 5e-3) << spec;
  }
}

}  // namespace
}  // namespace superstep
