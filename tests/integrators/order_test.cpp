/// Order in time of methods with a fixed step; error against rtol of adaptive ones.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "integrators/registry.hpp"
#include "support/problem.hpp"
#include "support/thermoelectric.hpp"

namespace superstep {
namespace {

using test::Problem;
using test::random_graph;
using test::rms_difference;
using test::run;

struct FixedStep {
  std::string spec;  ///< with {} for the step
  int order;
  double largest_step;
};

class StepHalving : public ::testing::TestWithParam<FixedStep> {};

INSTANTIATE_TEST_SUITE_P(Methods, StepHalving,
                         ::testing::Values(FixedStep{"forward-euler:step={}", 1, 0.01},
                                           FixedStep{"sts:n=4,nu=0.05,step={}", 1, 0.002},
                                           FixedStep{"sts:n=7,nu=1e-3,order=leja,step={}", 1, 0.001},
                                           FixedStep{"sts:n=3,nu=0.2,order=natural,step={}", 1, 0.002}));

TEST_P(StepHalving, ReachesItsDeclaredOrder) {
  Problem problem(random_graph({.nodes = 25, .seed = 7, .contrast = 4, .sources = true}));
  const auto exact = problem.exact(1.0);
  std::vector<double> errors;
  for (int level = 0; level < 4; ++level) {
    const double step = GetParam().largest_step / (1 << level);
    const auto result = run(fmt::format(fmt::runtime(GetParam().spec), step), problem, {1.0});
    ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
    errors.push_back(rms_difference(result.states.back(), exact));
  }
  ASSERT_GT(errors.back(),
            1e3 * std::numeric_limits<double>::epsilon());  // below, the slope is rounding noise
  EXPECT_NEAR(std::log2(errors[2] / errors[3]), GetParam().order, 0.15);
}

/// Every method of the registry with an order and a step to give it: halving the step falls into its order
/// before roundings hide it, on a network with an offset and sources.
class DeclaredOrder : public ::testing::TestWithParam<std::string> {};

std::vector<std::string> methods_with_a_step() {
  std::vector<std::string> names;
  for (const auto& entry : integrators())
    for (const auto& key : entry.keys)
      if (key.name == "step" && entry.order > 0) names.push_back(entry.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(Registry, DeclaredOrder, ::testing::ValuesIn(methods_with_a_step()),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(DeclaredOrder, IsReachedWhenTheStepIsHalved) {
  Graph graph = random_graph({.nodes = 25, .seed = 7, .contrast = 4, .sources = true});
  for (auto& value : graph.initial) value += 300;
  for (std::size_t k = 0; k < graph.nodes(); ++k)
    if (graph.is_fixed[k]) graph.fixed_value[k] += 300;
  Problem problem(std::move(graph));
  const auto exact = problem.exact(1.0);
  constexpr double roundings = 1e-10;  // of values of 300, after some thousand steps
  const int order = find_integrator(GetParam()).order;
  double previous = 0, best = std::numeric_limits<double>::infinity();
  for (int level = 0; level < 14; ++level) {
    const auto result = run(fmt::format("{}:step={}", GetParam(), 0.25 / (1 << level)), problem, {1.0});
    if (!result.outcome.ok()) continue;  // too long for an explicit method
    const double error = rms_difference(result.states.back(), exact);
    if (error < roundings && level == 0) GTEST_SKIP() << "linear networks are exact in one step";
    if (error < roundings) break;
    if (previous > 0) best = std::min(best, std::abs(std::log2(previous / error) - order));
    previous = error;
  }
  EXPECT_LE(best, 0.15) << "of order " << order;
}

/// The same where everything is nonlinear: two fields that act on each other, conductivities that follow the
/// temperature, radiation; constant inputs, and an electrode and an ambient that move.
void expect_the_order(const std::string& name, const test::Thermoelectric& settings) {
  const auto rhs = settings.build();
  Plan plan;
  constexpr double t_end = 0.5;  // within one piece of the tables
  plan.output_times = {t_end};
  plan.ranges.assign(rhs->fields().size(), {0, 1});
  plan.spans.assign(rhs->fields().size(), 1.0);
  const auto at_end = [&](const std::string& spec) {
    const auto method = make_integrator(spec);
    const std::vector<double> initial(rhs->size(), 0.3);
    try {
      method->prepare(*rhs, plan);
    } catch (const Refused&) {
      return std::vector<double>{};
    }
    method->start(0, initial);
    if (!method->advance(t_end).ok()) return std::vector<double>{};
    return std::vector<double>(method->state().begin(), method->state().end());
  };
  const auto truth = at_end("esdirk:rtol=1e-12");
  ASSERT_FALSE(truth.empty());
  constexpr double roundings = 1e-11;  // and the tolerance of the truth
  const int order = find_integrator(name).order;
  double previous = 0, best = std::numeric_limits<double>::infinity();
  for (int level = 0; level < 14; ++level) {
    const auto state = at_end(fmt::format("{}:step={}", name, 0.25 / (1 << level)));
    if (state.empty()) continue;  // refused, or too long for an explicit method
    const double error = rms_difference(state, truth);
    if (error < roundings) break;
    if (previous > 0) best = std::min(best, std::abs(std::log2(previous / error) - order));
    previous = error;
  }
  if (previous == 0) GTEST_SKIP() << "refused";
  EXPECT_LE(best, 0.15) << "of order " << order;
}

test::Thermoelectric everything() {
  using Kind = ConductivityLaw::Kind;
  const ConductivityLaw line{.kind = Kind::linear, .value = 2, .coefficient = -0.1, .reference = 0.2};
  const ConductivityLaw rise{
      .kind = Kind::sigmoid, .value = 1, .reference = 0.4, .amplitude = 1, .steepness = 2};
  return {.thermal = {line, rise}, .electric = {rise, line}, .convection = true, .radiation = true};
}

TEST_P(DeclaredOrder, IsReachedOnANonlinearScene) {
  expect_the_order(GetParam(), everything());
}

TEST_P(DeclaredOrder, IsReachedWhereInputsMove) {
  auto settings = everything();
  settings.tables = true;
  expect_the_order(GetParam(), settings);
}

TEST(Tolerance, ErrorOfAdaptiveMethodsFallsWithIt) {
  for (const auto& entry : integrators()) {
    if (!entry.adaptive) continue;
    Problem problem(random_graph({.nodes = 40, .seed = 17, .contrast = 100, .sources = true}));
    const auto exact = problem.exact(0.5);
    double previous = std::numeric_limits<double>::infinity();
    for (const double rtol : {1e-3, 1e-5, 1e-7}) {
      const auto result = run(fmt::format("{}:rtol={}", entry.name, rtol), problem, {0.5});
      ASSERT_TRUE(result.outcome.ok()) << entry.name << ": " << result.outcome.reason;
      const double error = rms_difference(result.states.back(), exact);
      EXPECT_LT(error, 30 * rtol) << entry.name;  // local control: the global error may be some times larger
      EXPECT_LT(error, 0.5 * previous) << entry.name;
      previous = std::max(error, 1e-12);
    }
  }
}

}  // namespace
}  // namespace superstep
