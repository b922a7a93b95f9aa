/// Spans of scenes whose inputs come in many pieces.

#include "integrators/spans.hpp"

#include <gtest/gtest.h>

#include "support/problem.hpp"

namespace superstep {
namespace {

/// A node without neighbours that a source warms: 1 K for every joule. The source is a profile of `knots`
/// knots, nothing but for 2 J in the piece after `pulse`.
double span_of_pulse(std::size_t knots, std::size_t pulse) {
  Graph graph = test::chain(2);
  graph.conductance[0] = 1e-9;
  graph.initial.assign(2, 300.0);
  TimeTable table;
  for (std::size_t k = 0; k < knots; ++k) {
    table.time.push_back(static_cast<double>(k + 1));
    table.value.push_back(k == pulse || k == pulse + 1 ? 1.0 : 0.0);
  }
  graph.tables.push_back(table);
  graph.tabled_sources.push_back({.node = 0, .table = 0});
  test::Problem problem(graph);
  Plan plan = problem.plan({static_cast<double>(knots + 1)});
  plan.ranges = {{.low = 300, .high = 300}};
  return find_spans(*problem.rhs, plan, 0, problem.initial).spans.front();
}

TEST(Spans, AreFoundWhateverTheNumberOfPieces) {
  for (const std::size_t knots : {5u, 62u, 63u, 64u, 65u, 66u, 200u})
    for (const std::size_t pulse : {std::size_t{1}, knots / 2, knots - 3})
      EXPECT_NEAR(span_of_pulse(knots, pulse), 2, 0.1) << knots << " knots, pulse after " << pulse;
}

}  // namespace
}  // namespace superstep
