/// Nodes of capacity 0 join what they touch, and are no clusters of their own.

#include <gtest/gtest.h>

#include "case/checks/health.hpp"
#include "case/roles.hpp"
#include "core/error.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

struct Ends {
  std::size_t i, j;
};

/// Nodes that start at 0, of which `without` have no capacity, joined by conductances of 1.
Graph network(std::size_t nodes, std::initializer_list<std::size_t> without,
              std::initializer_list<Ends> edges) {
  Graph graph = equal_nodes(nodes);
  for (const auto& [i, j] : edges) add_edge(graph, i, j, 1.0);
  for (const auto node : without) graph.capacity[node] = 0;
  return graph;
}

void fix(Graph& graph, std::size_t node, double value) {
  graph.is_fixed[node] = 1;
  graph.fixed_value[node] = value;
}

RoleReport report_of(Graph graph) {
  const auto algebraic = eliminate_algebraic_nodes(graph, "case.toml");
  return assign_roles(graph, "case.toml", {}, algebraic);
}

TEST(EliminatedNodes, InSeriesJoinTheirEnds) {
  auto chain = network(6, {1, 2, 3}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}});
  fix(chain, 0, 0);
  for (const double hot : {0.0, 1.0}) {  // of 0 nothing changes, and what is left is integrated all the same
    chain.initial[5] = hot;
    const auto report = report_of(chain);
    EXPECT_EQ(report.components, 1u);
    EXPECT_EQ(report.floating, 0u);
    EXPECT_EQ(report.idle_clusters, 0u);
    EXPECT_EQ(report.roles[2], NodeRole::idle) << "it is no part of the state";
    EXPECT_EQ(report.roles[4], NodeRole::free);
  }
}

TEST(EliminatedNodes, InLoopsJoinWhatTheyTouch) {
  auto loops =
      network(7, {1, 2, 3, 5}, {{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}, {3, 4}, {4, 5}, {5, 3}, {5, 6}});
  fix(loops, 0, 3);
  EXPECT_EQ(report_of(loops).components, 1u);
  EXPECT_EQ(report_of(loops).floating, 0u);
}

TEST(EliminatedNodes, JoinElectrodesThatTouchNothingElse) {
  auto two = network(4, {1}, {{0, 1}, {1, 2}, {2, 3}});
  fix(two, 0, 0);
  fix(two, 2, 1);
  EXPECT_EQ(report_of(two).components, 1u);
}

TEST(EliminatedNodes, OfAClusterWithoutAFixedNodeFloatWithIt) {
  auto two = network(6, {1, 4}, {{0, 1}, {1, 2}, {3, 4}, {4, 5}});
  fix(two, 0, 0);
  two.source[4] = 1;
  const auto report = report_of(two);
  EXPECT_EQ(report.components, 2u);
  EXPECT_EQ(report.floating, 1u);
  EXPECT_EQ(report.idle_clusters, 1u) << "the first starts at the value that it is held at";
}

TEST(EliminatedNodes, DoNotMoveAClusterByWhereTheyStart) {
  auto two = network(5, {1}, {{0, 1}, {1, 2}, {3, 4}});
  fix(two, 0, 0);
  two.initial[1] = 7;
  two.initial[3] = 1;
  EXPECT_EQ(report_of(two).idle_clusters, 1u);
}

TEST(EliminatedNodes, ThatFollowSurroundingsAloneAreNotIntegratedAndDoNotFloat) {
  auto apart = network(4, {2, 3}, {{0, 1}, {2, 3}});
  fix(apart, 0, 0);
  apart.initial[1] = 1;
  apart.convection = {{2, 0.5, 20, -1}};
  const auto report = report_of(apart);
  EXPECT_EQ(report.components, 2u);
  EXPECT_EQ(report.floating, 0u);
  EXPECT_EQ(report.idle_clusters, 0u);
}

TEST(EliminatedNodes, ThatTouchNothingAreRefused) {
  auto lonely = network(4, {2, 3}, {{0, 1}, {2, 3}});
  fix(lonely, 0, 0);
  EXPECT_THROW((void)report_of(lonely), InputError);
}

TEST(EliminatedNodes, AreCountedApartAndWarnedOfByNobody) {
  test::TemporaryFolder folder;
  folder.write("nodes.csv", "id,capacity,source,initial,fixed\n1,1,0,0,0\n2,0,0,0,\n3,0,0,0,\n4,1,0,0,\n");
  folder.write("edges.csv", "i,j,conductance\n1,2,1\n2,3,1\n3,4,1\n");
  const auto scene = load_scene(
      folder.write("case.toml", "t_end = 1\n[network]\nnodes = \"nodes.csv\"\nedges = \"edges.csv\"\n"));
  EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
  EXPECT_EQ(scene.rhs->size(), 1u) << "even where nothing changes";
  const FieldHealth health = assess_network(scene).fields.front();
  EXPECT_EQ(health.eliminated, 2u);
  EXPECT_EQ(health.idle, 0u);
  EXPECT_EQ(health.isolated, 0u);
  EXPECT_EQ(health.components, 1u);
  EXPECT_EQ(health.coordination_mean, 1);
}

}  // namespace
}  // namespace superstep
