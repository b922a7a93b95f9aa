/// Nodes without a capacity are eliminated exactly.

#include "network/eliminate.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "core/error.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

/// The whole system's Laplacian with exchange on its diagonal, and its right-hand side without fixed values.
struct Dense {
  Eigen::MatrixXd k;
  Eigen::VectorXd y;
};

Dense dense(const Graph& graph, double t) {
  const auto n = static_cast<Eigen::Index>(graph.nodes());
  Dense out{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)};
  for (std::size_t e = 0; e < graph.edges(); ++e) {
    const auto i = graph.i[e], j = graph.j[e];
    out.k(i, i) += graph.conductance[e];
    out.k(j, j) += graph.conductance[e];
    out.k(i, j) -= graph.conductance[e];
    out.k(j, i) -= graph.conductance[e];
  }
  for (std::size_t k = 0; k < graph.nodes(); ++k) out.y(static_cast<Eigen::Index>(k)) += graph.source[k];
  for (const auto& exchange : graph.convection) {
    const double ambient =
        exchange.table < 0 ? exchange.ambient : graph.tables[static_cast<std::size_t>(exchange.table)].at(t);
    out.k(exchange.node, exchange.node) += exchange.coefficient;
    out.y(exchange.node) += exchange.coefficient * ambient;
  }
  for (const auto& source : graph.tabled_sources)
    out.y(source.node) += graph.tables[static_cast<std::size_t>(source.table)].at(t);
  return out;
}

Graph random_graph(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(0.1, 1);
  std::uniform_int_distribution<std::size_t> pick(0, 29);
  Graph graph = equal_nodes(30);
  for (std::size_t k = 1; k < 30; ++k) add_edge(graph, k, k - 1, part(random));
  for (int e = 0; e < 40; ++e) {
    const auto i = pick(random), j = pick(random);
    if (i != j) add_edge(graph, i, j, part(random));
  }
  for (std::size_t k = 0; k < 30; ++k) {
    graph.source[k] = part(random);
    if (k % 3 != 0) graph.capacity[k] = 0;
  }
  graph.is_fixed[0] = graph.is_fixed[7] = 1;
  graph.fixed_value[0] = 5;
  graph.fixed_value[7] = -2;
  graph.tables = {{{0, 10}, {1, 3}}, {{0, 10}, {20, 40}}};
  graph.tabled_sources = {{4, 0}, {5, 0}};
  graph.convection = {{8, 0.7, 25, -1}, {9, 0.3, 25, -1}, {10, 0.5, 0, 1}};
  return graph;
}

TEST(Elimination, LeavesTheRatesOfTheOthersAndRecoversValues) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Graph whole = random_graph(seed);
    Graph reduced = whole;
    const auto algebraic = eliminate_algebraic_nodes(reduced, "test");
    std::vector<char> gone(30, 0);
    for (const auto& one : algebraic) gone[static_cast<std::size_t>(one.node)] = 1;
    const double t = 4;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(-1, 1);
    std::vector<double> value(30);
    for (std::size_t k = 0; k < 30; ++k) value[k] = whole.is_fixed[k] ? whole.fixed_value[k] : part(random);
    recover_algebraic_values(algebraic, reduced, t, value);
    const Dense full = dense(whole, t), small = dense(reduced, t);
    const Eigen::VectorXd x = Eigen::Map<Eigen::VectorXd>(value.data(), 30);
    const Eigen::VectorXd rate = full.y - full.k * x, reduced_rate = small.y - small.k * x;
    // Some hundred operations with numbers of order 10.
    for (std::size_t k = 0; k < 30; ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      if (whole.is_fixed[k]) continue;
      const double wanted = gone[k] ? 0.0 : reduced_rate(row);  // the balance of one without capacity holds
      EXPECT_NEAR(rate(row), wanted, 1e-11) << k;
    }
    EXPECT_EQ(algebraic.size(), 19u);  // 20 of 30 have no capacity, one of them (7) is fixed
  }
}

TEST(Elimination, RefusesWhatNothingDetermines) {
  const auto refused = [](Graph graph) {
    return test::message_of<InputError>([&] { (void)eliminate_algebraic_nodes(graph, "c.toml:3"); });
  };
  Graph lonely = equal_nodes(3);
  add_edge(lonely, 1, 2, 1.0);
  lonely.capacity = {1, 0, 0};
  EXPECT_NE(refused(lonely).find("nothing determines its value"), std::string::npos);
  Graph nothing = equal_nodes(2);
  add_edge(nothing, 0, 1, 1.0);
  nothing.capacity = {0, 0};
  EXPECT_NE(refused(nothing).find("every free node has capacity 0"), std::string::npos);
  Graph glows = equal_nodes(2);
  add_edge(glows, 0, 1, 1.0);
  glows.capacity = {0, 1};
  glows.radiation = {{0, 1e-8, 300, -1}};
  EXPECT_NE(refused(glows).find("radiates"), std::string::npos);
}

}  // namespace
}  // namespace superstep
