/// The exponential: accuracy down to rounding, its bases, many outputs, driven inputs, probes without states.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
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
using test::run;

TEST(Exponential, DeliversItsToleranceDownToRounding) {
  for (const std::string basis : {"auto", "chebyshev", "lanczos", "shift-invert"})
    for (const double rtol : {1e-2, 1e-5, 1e-9, 1e-14}) {
      if (basis == "shift-invert" && rtol < 1e-12) continue;  // it asks what vectors change: rounding
      Problem problem(random_graph({.nodes = 150, .seed = 4, .contrast = 1e3, .fixed = 3, .sources = true}));
      const auto result =
          run(fmt::format("exponential:basis={},rtol={}", basis, rtol), problem, {0.01, 0.5, 4.0});
      ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
      for (std::size_t k = 0; k < 3; ++k) {
        const double t = std::vector{0.01, 0.5, 4.0}[k];
        EXPECT_LT(test::rms_difference(result.states[k], problem.exact(t)), 3 * rtol + 1e-13)
            << basis << ' ' << rtol;
      }
    }
}

TEST(Exponential, ManyOutputsCostLittleMoreThanTheLast) {
  Problem problem(test::chain(200, 0.0, 1.0));
  const auto one = run("exponential:basis=chebyshev", problem, {8000});
  const auto eight =
      run("exponential:basis=chebyshev", problem, {1000, 2000, 3000, 4000, 5000, 6000, 7000, 8000});
  EXPECT_EQ(one.sweeps, eight.sweeps);
  EXPECT_LT(max_difference(eight.states.back(), one.states.back()), 1e-12);
  const auto twenty = run("exponential:basis=chebyshev", problem, [] {
    std::vector<double> times;
    for (int k = 1; k <= 20; ++k) times.push_back(400.0 * k);
    return times;
  }());
  EXPECT_LT(max_difference(twenty.states.back(), one.states.back()),
            1e-7);  // three batches, each to its tolerance
}

/// Offsets cost no digits but those that storing the values costs: a network around 0 and the same one 2^20
/// higher, with sources, a ramp that turns and a transient of many terms. Roundings of every term would leave
/// six digits certain.
TEST(Exponential, KeepsItsDigitsWhereValuesAreLargeAgainstTheirSpan) {
  constexpr double offset = 1 << 20;
  Graph high = random_graph({.nodes = 60, .seed = 5, .contrast = 1e4, .fixed = 2, .sources = true});
  Graph low = high;
  for (std::size_t k = 0; k < high.nodes(); ++k) {
    high.initial[k] += offset;
    high.fixed_value[k] += offset;
    low.initial[k] = high.initial[k] - offset;  // exactly
    low.fixed_value[k] = high.fixed_value[k] - offset;
  }
  const auto held =
      static_cast<std::size_t>(std::find(low.is_fixed.begin(), low.is_fixed.end(), 1) - low.is_fixed.begin());
  for (Graph* graph : {&low, &high}) {
    const double base = graph == &high ? offset : 0;
    graph->tables.push_back(TimeTable{.time = {0, 2, 5}, .value = {base, base + 1, base - 0.5}});
    graph->fixed_table.assign(graph->nodes(), -1);
    graph->fixed_table[held] = 0;
  }
  Problem around_zero(low), far_from_zero(high);
  const std::vector<double> times{0.5, 2, 4};
  const auto expected = run("exponential:basis=chebyshev,rtol=1e-14", around_zero, times);
  const auto result = run("exponential:basis=chebyshev,rtol=1e-14", far_from_zero, times);
  ASSERT_TRUE(expected.outcome.ok() && result.outcome.ok());
  ASSERT_GT(result.sweeps, 1000u);
  constexpr double stored = offset * std::numeric_limits<double>::epsilon();
  for (std::size_t k = 0; k < times.size(); ++k) {
    std::vector<double> moved = result.states[k];
    for (double& value : moved) value -= offset;
    EXPECT_LT(max_difference(moved, expected.states[k]), 4 * stored) << times[k];
  }
  EXPECT_LT(result.statistics.error_bound, 20 * stored);  // in spans, and those are above 1/2
}

/// Micrometres or metres: capacities and conductances times 1e-12 or 1e12 are the same network, in which
/// lengths of rates in the capacity norm are a million times smaller or larger.
TEST(Exponential, UnitsOfTheCapacitiesDoNotMatter) {
  const Graph graph = random_graph({.nodes = 80, .seed = 6, .contrast = 50, .fixed = 2, .sources = true});
  Problem one(graph);
  const std::vector<double> times{0.02, 0.4};
  for (const double factor : {1e-12, 1e12}) {
    Graph scaled = graph;
    for (auto* values : {&scaled.capacity, &scaled.conductance, &scaled.source})
      for (double& value : *values) value *= factor;
    Problem other(scaled);
    for (const char* basis : {"lanczos", "shift-invert", "chebyshev"})
      for (const double rtol : {1e-3, 1e-8}) {
        const auto result = run(fmt::format("exponential:basis={},rtol={:g}", basis, rtol), other, times);
        ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
        for (std::size_t k = 0; k < times.size(); ++k)
          EXPECT_LT(test::rms_difference(result.states[k], one.exact(times[k])), 2 * rtol)
              << basis << ' ' << rtol << ' ' << factor << ' ' << times[k];
      }
  }
}

/// 1 MiB holds 52 of these vectors, where more are needed.
TEST(Exponential, LanczosBeginsAnewWhereItsMemoryEnds) {
  Problem problem(test::chain(2500, 0.0, 1.0));
  const std::vector<double> times{20, 300, 1000};
  const auto expected = run("exponential:basis=chebyshev,rtol=1e-13", problem, times);
  const auto one = run("exponential:basis=lanczos,rtol=1e-8", problem, times);
  const auto several = run("exponential:basis=lanczos,rtol=1e-8,memory=1", problem, times);
  ASSERT_TRUE(one.outcome.ok() && several.outcome.ok()) << several.outcome.reason;
  EXPECT_GT(several.sweeps, one.sweeps);
  EXPECT_LE(several.statistics.max_stages, 52);
  for (std::size_t k = 0; k < times.size(); ++k) {
    EXPECT_LT(test::rms_difference(one.states[k], expected.states[k]), 1e-8);
    EXPECT_LT(test::rms_difference(several.states[k], expected.states[k]), 1e-8);
  }
  EXPECT_NEAR(several.statistics.inflow, one.statistics.inflow, 1e-6 * std::abs(one.statistics.inflow));
  // 1 MiB holds six of these vectors, and twice as many in single precision.
  Problem too_large(test::chain(20'000, 0.0, 1.0));
  EXPECT_THROW(run("exponential:basis=lanczos,rtol=1e-6,memory=1", too_large, {1}), Refused);
  const auto held = run("exponential:basis=lanczos,rtol=1e-3,memory=1", too_large, {1});
  EXPECT_TRUE(held.outcome.ok()) << held.outcome.reason;
  EXPECT_LE(held.statistics.max_stages, 13);
}

/// Instants five decades apart take several poles, twenty of them several batches.
TEST(Exponential, ShiftInvertServesInstantsFarApart) {
  Problem problem(random_graph({.nodes = 120, .seed = 14, .contrast = 1e6, .fixed = 2, .sources = true}));
  std::vector<double> times;
  for (int k = 0; k < 20; ++k) times.push_back(1e-5 * std::pow(10.0, k * 0.25));
  const auto result = run("exponential:basis=shift-invert,rtol=1e-7", problem, times);
  ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
  EXPECT_GE(result.statistics.factorizations, 2u);
  EXPECT_LE(result.statistics.factorizations, 4u);
  for (std::size_t k = 0; k < times.size(); ++k)
    EXPECT_LT(test::rms_difference(result.states[k], problem.exact(times[k])), 1e-7) << times[k];
}

TEST(Exponential, ChoosesItsBasisAndSaysWhich) {
  const auto choice = [](Problem& problem, const std::string& spec, double t) {
    const auto integrator = make_integrator(spec);
    integrator->prepare(*problem.rhs, problem.plan({t}));
    integrator->start(0, problem.initial);
    EXPECT_TRUE(integrator->advance(t).ok());
    return integrator->choice();
  };
  Problem mild(random_graph({.nodes = 4000, .seed = 3})),
      stiff(random_graph({.nodes = 300, .seed = 3, .contrast = 1e11}));
  EXPECT_TRUE(choice(mild, "exponential:rtol=1e-6", 3).starts_with("basis=lanczos"));
  EXPECT_TRUE(choice(stiff, "exponential:rtol=1e-6", 10).starts_with("basis=shift-invert"));
  EXPECT_TRUE(choice(mild, "exponential:rtol=1e-15", 3).starts_with("basis=chebyshev"));  // rounding
  EXPECT_EQ(choice(mild, "exponential:basis=chebyshev", 3), "");
}

/// Inputs of hundreds of knots and some steps: one space for the start and one for each shape hold them all.
/// Chebyshev takes them piece by piece.
TEST(Exponential, TakesAllKnotsOfAnInputAtOnce) {
  Graph graph = random_graph({.nodes = 400, .seed = 9, .contrast = 30, .fixed = 2, .sources = true});
  const auto constant_graph = graph;
  TimeTable profile, pulses{.time = {-1, 0.7, 0.7, 1.1, 1.1, 9}, .value = {0, 0, 20, 20, 0, 3}};
  for (int k = 0; k <= 500; ++k) {
    profile.time.push_back(0.01 * k - 0.2);  // it has begun before the run does
    profile.value.push_back(std::sin(0.7 * k) + 0.5 * (k % 3));
  }
  graph.tables = {profile, pulses};
  graph.fixed_table.assign(graph.nodes(), -1);
  const auto held = std::find(graph.is_fixed.begin(), graph.is_fixed.end(), 1) - graph.is_fixed.begin();
  graph.fixed_table[static_cast<std::size_t>(held)] = 0;
  for (const std::int32_t node : {3, 50, 51}) graph.tabled_sources.push_back({.node = node, .table = 1});
  const std::vector<double> times{0.05, 0.7, 0.9, 4};
  Problem driven(graph), constant(constant_graph);
  const auto exact = run("exponential:basis=chebyshev,rtol=1e-13", driven, times);
  ASSERT_TRUE(exact.outcome.ok());
  for (const double rtol : {1e-3, 1e-6, 1e-9}) {
    const auto spec = fmt::format("exponential:basis=lanczos,rtol={:g}", rtol);
    const auto result = run(spec, driven, times);
    ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
    const double span = 20;  // at least, by the pulses
    double error = 0;
    for (std::size_t k = 0; k < times.size(); ++k)
      error = std::max(error, test::rms_difference(result.states[k], exact.states[k]));
    EXPECT_LT(error, rtol * span) << rtol;
    EXPECT_GT(result.statistics.error_bound, 0);
    EXPECT_NEAR(result.statistics.inflow, exact.statistics.inflow,
                10 * rtol * std::abs(exact.statistics.inflow));
    EXPECT_LE(result.statistics.max_stages, 2 * run(spec, constant, times).statistics.max_stages)
        << "vectors of one space, whatever the number of knots";
  }
}

/// A ramp of a rounding's width is a step, and a needle is its area: as kinks they are differences of huge
/// numbers.
TEST(Exponential, TakesRampsThatAreNearlySteps) {
  constexpr double span = 20;
  for (const double width : {1e-16, 1e-10, 1e-7, 1e-4, 1e-2}) {
    Graph graph = random_graph({.nodes = 60, .seed = 4, .contrast = 100, .fixed = 2});
    graph.tables = {
        {.time = {0.5, std::nextafter(0.5, 1) + width, 1.0, 1.0 + width}, .value = {0, 20, 20, 0}}};
    graph.tabled_sources = {{.node = 3, .table = 0}};
    if (width > 1e-12) {  // what a needle of less holds, the roundings of its instants decide
      graph.tables.push_back({.time = {0.3, 0.3 + width, 0.3 + 2 * width}, .value = {0, 3 / width, 0}});
      graph.tabled_sources.push_back({.node = 40, .table = 1});
    }
    Problem problem(graph);
    const std::vector<double> times{0.3 + 3 * width, 0.7, 1.5, 6};
    const auto states = [&](const std::string& spec, double& rounding) {
      Plan plan = problem.plan(times);
      plan.spans = {span};
      const auto integrator = make_integrator(spec);
      integrator->prepare(*problem.rhs, plan);
      integrator->start(0, problem.initial);
      std::vector<std::vector<double>> out;
      for (const double t : times) {
        EXPECT_TRUE(integrator->advance(t).ok()) << spec;
        out.emplace_back(integrator->state().begin(), integrator->state().end());
      }
      rounding = integrator->statistics().rounding_bound;
      return out;
    };
    double rounding = 0;
    const auto exact = states("exponential:basis=chebyshev,rtol=1e-13", rounding);
    for (const double rtol : {1e-4, 1e-7}) {
      const auto found = states(fmt::format("exponential:basis=lanczos,rtol={:g}", rtol), rounding);
      for (std::size_t k = 0; k < times.size(); ++k)
        EXPECT_LT(test::rms_difference(found[k], exact[k]), span * (rtol + rounding))
            << width << ' ' << rtol << ' ' << times[k];
    }
    if (width < 1e-12) {
      EXPECT_LT(rounding, 1e-12) << width;
    }
  }
}

TEST(Exponential, ProbesNeedNoStates) {
  Problem problem(test::chain(200, 0.0, 1.0));
  ProbeHistory history(2);
  Plan plan = problem.plan({100, 5000});
  plan.full_states = false;
  plan.probes = {3, 77};
  plan.history = &history;
  for (const char* spec : {"exponential:basis=chebyshev,rtol=1e-12", "exponential:basis=lanczos,rtol=1e-12",
                           "exponential:basis=shift-invert,rtol=1e-12"}) {
    history.clear();
    const auto integrator = make_integrator(spec);
    integrator->prepare(*problem.rhs, plan);
    integrator->start(0, problem.initial);
    for (const double t : plan.output_times) {
      ASSERT_TRUE(integrator->advance(t).ok());
      const auto exact = problem.exact(t);
      EXPECT_NEAR(history.value(history.size() - 1, 0), exact[3], 1e-11) << spec;
      EXPECT_NEAR(history.value(history.size() - 1, 1), exact[77], 1e-11) << spec;
    }
  }
}

}  // namespace
}  // namespace superstep
