#include "network/network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/error.hpp"
#include "network/components.hpp"
#include "network/network_in_order.hpp"
#include "network/ordering.hpp"
#include "network/spd_solver.hpp"
#include "support/sample_graphs.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

using test::chain;
using test::plain_roles;
using test::random_graph;

TEST(Network, AnOrderThatIsKnownIsKept) {
  const Graph graph = random_graph({.nodes = 60, .seed = 3, .fixed = 3});
  const Network found = build_network(graph, plain_roles(graph));
  const Network again = build_network_in_order(graph, plain_roles(graph), 0, found.node_of_row);
  EXPECT_EQ(again.node_of_row, found.node_of_row);
  EXPECT_EQ(again.row_begin, found.row_begin);
  EXPECT_EQ(again.column, found.column);
  EXPECT_EQ(again.conductance, found.conductance);
  std::vector<std::int32_t> backwards(graph.nodes());  // those that are fixed are passed over
  for (std::size_t k = 0; k < backwards.size(); ++k)
    backwards[k] = static_cast<std::int32_t>(backwards.size() - 1 - k);
  const Network other = build_network_in_order(graph, plain_roles(graph), 0, backwards);
  ASSERT_EQ(other.size(), found.size());
  const auto sums = found.total_conductance(), others = other.total_conductance();
  for (std::size_t row = 0; row < other.size(); ++row) {
    const auto node = static_cast<std::size_t>(other.node_of_row[row]);
    EXPECT_TRUE(row == 0 || other.node_of_row[row] < other.node_of_row[row - 1]);
    EXPECT_EQ(other.row_of_node[node], static_cast<std::int32_t>(row));
    EXPECT_EQ(other.capacity[row], graph.capacity[node]);
    EXPECT_NEAR(others[row], sums[static_cast<std::size_t>(found.row_of_node[node])], 1e-13 * others[row])
        << "summed in another order";
  }
}

TEST(Network, HoldsEveryEdgeOnceInEachDirection) {
  const Graph graph = random_graph({.nodes = 60, .seed = 3, .fixed = 3});
  const Network network = build_network(graph, plain_roles(graph));
  std::set<std::tuple<std::int64_t, std::int64_t, double>> expected, found;
  std::size_t ghosts = 0;
  for (std::size_t k = 0; k < graph.edges(); ++k) {
    const auto i = static_cast<std::size_t>(graph.i[k]), j = static_cast<std::size_t>(graph.j[k]);
    if (!graph.is_fixed[i] && !graph.is_fixed[j]) {
      expected.insert({graph.id[i], graph.id[j], graph.conductance[k]});
      expected.insert({graph.id[j], graph.id[i], graph.conductance[k]});
    } else if (graph.is_fixed[i] != graph.is_fixed[j]) {
      ++ghosts;
    }
  }
  for (std::size_t row = 0; row < network.size(); ++row)
    for (auto k = network.row_begin[row]; k < network.row_begin[row + 1]; ++k) {
      const auto node = static_cast<std::size_t>(network.node_of_row[row]);
      const auto other = network.column[static_cast<std::size_t>(k)];
      const auto neighbour = static_cast<std::size_t>(network.node_of_row[static_cast<std::size_t>(other)]);
      found.insert({graph.id[node], graph.id[neighbour], network.conductance[static_cast<std::size_t>(k)]});
    }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(network.ghost_edges.size(), ghosts);
  EXPECT_EQ(network.size(), graph.nodes() - 3);
}

TEST(Network, PairStepIsTheSmallestOverEdgesWithAFreeEnd) {
  Graph graph = chain(4, 0.0, 1.0);
  graph.capacity = {1, 2, 4, 1};
  const auto roles = plain_roles(graph);
  // edges: (1,2) -> 4/3, (2,4) -> 8/3, (4,1) -> 8/5
  EXPECT_DOUBLE_EQ(min_pair_step(graph, roles, graph.conductance), 4.0 / 3.0);
  EXPECT_EQ(min_pair_step(chain(1), plain_roles(chain(1)), {}), std::numeric_limits<double>::infinity());
}

TEST(Network, DropsIdleNodesAndZeroEdges) {
  Graph graph = chain(4);
  graph.conductance[1] = 0;
  const std::vector<NodeRole> roles = {NodeRole::free, NodeRole::free, NodeRole::idle, NodeRole::idle};
  const Network network = build_network(graph, roles);
  EXPECT_EQ(network.size(), 2u);
  EXPECT_EQ(network.nonzeros(), 2u);
  EXPECT_EQ(network.row_of_node[2], -1);
}

TEST(Components, CountsByConductingEdges) {
  Graph graph = chain(5);
  graph.conductance[2] = 0;
  const auto components = connected_components(5, graph.i, graph.j, graph.conductance);
  EXPECT_EQ(components.count, 2u);
  EXPECT_EQ(components.of_node[0], components.of_node[2]);
  EXPECT_NE(components.of_node[2], components.of_node[3]);
}

/// Neighbours of every row of a network, in compressed form.
struct Neighbours {
  explicit Neighbours(const Graph& graph) {
    const Network network = build_network(graph, plain_roles(graph));
    begin = network.row_begin;
    column = network.column;
  }
  std::vector<std::int64_t> begin;
  std::vector<std::int32_t> column;
};

TEST(Ordering, NarrowsAShuffledChain) {
  const Neighbours rows(test::relabelled(chain(500), 5));
  const auto order = reverse_cuthill_mckee(rows.begin, rows.column);
  std::vector<std::ptrdiff_t> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    place[static_cast<std::size_t>(order[k])] = static_cast<std::ptrdiff_t>(k);
  for (std::size_t row = 0; row < order.size(); ++row)
    for (auto k = rows.begin[row]; k < rows.begin[row + 1]; ++k)
      EXPECT_LE(
          std::abs(place[static_cast<std::size_t>(rows.column[static_cast<std::size_t>(k)])] - place[row]),
          2);
}

TEST(Ordering, GroupsByLengthWithinWindowsAndKeepsTheRest) {
  constexpr std::size_t window = 1024;
  const Neighbours rows(test::random_graph({.nodes = 2500, .seed = 3}));
  const auto before = reverse_cuthill_mckee(rows.begin, rows.column);
  auto order = before;
  group_by_length(rows.begin, order);
  for (std::size_t begin = 0; begin < order.size(); begin += window) {
    const std::size_t end = std::min(begin + window, order.size());
    const auto length = [&](std::size_t k) {
      const auto row = static_cast<std::size_t>(order[k]);
      return rows.begin[row + 1] - rows.begin[row];
    };
    for (std::size_t k = begin + 1; k < end; ++k) EXPECT_LE(length(k), length(k - 1));
    const auto part = [&](std::vector<std::int32_t> all) {
      std::sort(all.begin() + static_cast<std::ptrdiff_t>(begin),
                all.begin() + static_cast<std::ptrdiff_t>(end));
      return std::vector<std::int32_t>(all.begin() + static_cast<std::ptrdiff_t>(begin),
                                       all.begin() + static_cast<std::ptrdiff_t>(end));
    };
    EXPECT_EQ(part(order), part(before)) << "the same rows in each window";
  }
}

TEST(SpdSolver, SteadyChainIsLinear) {
  const Graph graph = chain(11, 0.0, 10.0);
  const Network network = build_network(graph, plain_roles(graph));
  const auto x = steady_state(network);
  for (std::size_t row = 0; row < x.size(); ++row)
    EXPECT_NEAR(x[row], static_cast<double>(graph.id[static_cast<std::size_t>(network.node_of_row[row])]),
                1e-12);
}

TEST(SpdSolver, NodesThatAreAllHeldLeaveNothingToSolve) {
  const Graph graph = chain(2, 0.0, 10.0);
  EXPECT_TRUE(steady_state(build_network(graph, plain_roles(graph))).empty());
}

TEST(SpdSolver, RefusesAFloatingCluster) {
  Graph graph = chain(6, 0.0);
  graph.conductance[3] = 0;
  const Network network = build_network(graph, plain_roles(graph));
  EXPECT_FALSE(every_component_is_held(network));
  EXPECT_THROW(static_cast<void>(steady_state(network)), NumericalError);
  EXPECT_NO_THROW(SpdSolver(network, 1.0));
}

class GraphFiles : public ::testing::Test {
 protected:
  std::string complaint(const std::string& nodes, const std::string& edges) {
    const auto n = folder_.write("nodes.csv", nodes), e = folder_.write("edges.csv", edges);
    return test::message_of<InputError>([&] { static_cast<void>(read_graph(n, e)); });
  }
  test::TemporaryFolder folder_;
  const std::string nodes_ = "id,capacity,source,initial,fixed\n7,1,0,0,\n-3,2,0.5,1,\n900,1,0,0,10\n";
  const std::string edges_ = "i,j,conductance\n7,-3,1\n900,7,2.5\n";
};

TEST_F(GraphFiles, ReadsNonContiguousIds) {
  const Graph graph = read_graph(folder_.write("n.csv", nodes_), folder_.write("e.csv", edges_));
  EXPECT_EQ(graph.id, (std::vector<std::int64_t>{7, -3, 900}));
  EXPECT_TRUE(graph.is_fixed[2]);
  EXPECT_EQ(graph.fixed_value[2], 10);
  EXPECT_EQ(graph.conductance, (std::vector<double>{1, 2.5}));
}

TEST_F(GraphFiles, EveryBadRowIsOneClearError) {
  const auto expect = [&](const std::string& nodes, const std::string& edges, const std::string& part) {
    const auto message = complaint(nodes, edges);
    EXPECT_NE(message.find(part), std::string::npos) << "wanted: " << part << "\n   got: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  };
  expect("id,capacity,source,initial\n1,1,0,0\n", edges_, "nodes.csv:1: column 'fixed' is missing");
  expect("id,capacity,source,initial,fixed\n1,1,0\n", edges_, "nodes.csv:2: row");
  expect("id,capacity,source,initial,fixed\n1,1,5,0,0,\n", edges_, "nodes.csv:2: row");
  expect("id,capacity,source,initial,fixed\n1,0x1F,0,0,\n", edges_,
         "nodes.csv:2: column 'capacity' is '0x1F'");
  expect("id,capacity,source,initial,fixed\n1,1e999,0,0,\n", edges_, "1e999");
  expect("id,capacity,source,initial,fixed\n1,1abc,0,0,\n", edges_, "1abc");
  expect("id,capacity,source,initial,fixed\n1,nan,0,0,\n", edges_, "nan");
  expect("id,capacity,source,initial,fixed\n1,-2,0,0,\n", edges_,
         "capacity of node 1 is -2; it must be >= 0");
  expect("id,capacity,source,initial,fixed\n1,1,0,0,\n1,1,0,0,\n", edges_, "nodes.csv:3: id 1 stands twice");
  expect("id,capacity,source,initial,fixed\n", edges_, "no nodes");
  expect("", edges_, "is empty");
  expect(nodes_, "i,j,conductance\n7,7,1\n", "edges.csv:2: edge 7-7 joins a node with itself");
  expect(nodes_, "i,j,conductance\n7,8,1\n", "edges.csv:2: edge end 8 is not a node");
  expect(nodes_, "i,j,conductance\n7,-3,-1\n", "it must be finite and >= 0");
  expect(nodes_, "i,j,conductance\n7,-3,inf\n", "'inf'");
  expect(nodes_, std::string("i,j\0", 4), "binary");
}

/// A table that rules a fixed value and a source: the value is counted from the origin, the source is not.
TEST(NetworkOrigin, MovesValuesAndLeavesSources) {
  Graph graph = equal_nodes(3);
  add_edge(graph, 0, 1, 2);
  add_edge(graph, 1, 2, 1);
  graph.tables = {{.time = {0, 1}, .value = {10, 12}}, {.time = {0, 1}, .value = {20, 30}}};
  graph.is_fixed[0] = 1;
  graph.fixed_table = {0, -1, -1};
  graph.tabled_sources = {{1, 0}};
  graph.convection = {{1, 0.5, 11, -1}, {2, 0.5, 0, 1}};
  const std::vector<NodeRole> roles = {NodeRole::fixed, NodeRole::free, NodeRole::free};
  const Network network = build_network(graph, roles, 10);
  EXPECT_EQ(network.origin, 10);
  ASSERT_EQ(network.ghost_value.size(), 3U);
  for (std::size_t ghost = 0; ghost < 3; ++ghost) {
    const auto table = network.ghost_table[ghost];
    const double whole = build_network(graph, roles).ghost_value[ghost];
    EXPECT_EQ(network.ghost_value[ghost], whole - 10);
    if (table < 0) continue;
    EXPECT_EQ(network.tables[static_cast<std::size_t>(table)].value.front(), whole - 10);
  }
  ASSERT_EQ(network.tabled_sources.size(), 1U);
  const auto source = static_cast<std::size_t>(network.tabled_sources.front().table);
  EXPECT_EQ(network.tables[source].value, (std::vector<double>{10, 12}));
}

}  // namespace
}  // namespace superstep
