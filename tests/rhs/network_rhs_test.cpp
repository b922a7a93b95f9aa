#include "rhs/network_rhs.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <numbers>

#include "rhs/lanczos.hpp"
#include "support/problem.hpp"

namespace superstep {
namespace {

using test::Problem;
using test::random_graph;

std::vector<double> wave(std::size_t n, double phase) {
  std::vector<double> y(n);
  for (std::size_t k = 0; k < n; ++k) y[k] = std::sin(phase + 1.7 * static_cast<double>(k));
  return y;
}

/// f straight from the graph's edge list: the oracle.
std::vector<double> derivative(const Problem& problem, const std::vector<double>& y) {
  const auto& graph = problem.graph;
  const auto& rows = problem.rhs->network().row_of_node;
  std::vector<double> flux(y.size(), 0.0);
  const auto value = [&](std::size_t node) {
    return rows[node] >= 0 ? y[static_cast<std::size_t>(rows[node])] : graph.fixed_value[node];
  };
  for (std::size_t k = 0; k < graph.edges(); ++k) {
    const auto i = static_cast<std::size_t>(graph.i[k]), j = static_cast<std::size_t>(graph.j[k]);
    const double flow = graph.conductance[k] * (value(j) - value(i));
    if (rows[i] >= 0) flux[static_cast<std::size_t>(rows[i])] += flow;
    if (rows[j] >= 0) flux[static_cast<std::size_t>(rows[j])] -= flow;
  }
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    if (rows[node] >= 0) {
      auto& f = flux[static_cast<std::size_t>(rows[node])];
      f = (f + graph.source[node]) / graph.capacity[node];
    }
  return flux;
}

TEST(NetworkRhs, MatchesTheEdgeList) {
  Problem problem(random_graph({.nodes = 80, .seed = 2, .contrast = 1e3, .fixed = 4, .sources = true}));
  const auto y = wave(problem.rhs->size(), 0.3);
  std::vector<double> f(y.size());
  (*problem.rhs)(0, y, f);
  const auto expected = derivative(problem, y);
  for (std::size_t k = 0; k < f.size(); ++k)
    EXPECT_NEAR(f[k], expected[k], 1e-12 * 1e4);  // rounding of terms up to 1e4
  EXPECT_EQ(problem.rhs->counters().sweeps, 1u);
}

/// Scenes of which nobody has the whole give back their rows: what is chosen by the facts must not change.
TEST(NetworkRhs, GivenBackRowsChangeNeitherFactsNorValues) {
  const Graph graph = random_graph({.nodes = 80, .seed = 6, .contrast = 1e3, .fixed = 4, .sources = true});
  const Network network = build_network(graph, test::plain_roles(graph));
  NetworkRhs kept(network, "temperature", "K", 1), given_back(network, "temperature", "K", 1, false);
  EXPECT_EQ(given_back.network().column.size(), 0u) << "they are given back";
  EXPECT_EQ(kept.facts().fields[0].nonzeros, network.nonzeros());
  EXPECT_EQ(given_back.facts().fields[0].nonzeros, network.nonzeros());
  EXPECT_EQ(given_back.facts().fields[0].source_rate, kept.facts().fields[0].source_rate);
  const auto y = wave(kept.size(), 0.2);
  EXPECT_EQ(given_back.spectral_bound(0, y), kept.spectral_bound(0, y));
  std::vector<double> f(y.size()), g(y.size());
  kept(0, y, f);
  given_back(0, y, g);
  EXPECT_EQ(f, g);
  std::vector<double> values(kept.pattern().row.size()), others(given_back.pattern().row.size());
  ASSERT_EQ(values.size(), others.size());
  kept.jacobian(0, y, values);
  given_back.jacobian(0, y, others);
  for (std::size_t k = 0; k < values.size(); ++k)
    EXPECT_NEAR(others[k], values[k], 1e-12 * 1e4);  // diagonals are summed in another order
}

TEST(NetworkRhs, FusedStageEqualsItsParts) {
  Problem problem(random_graph({.nodes = 50, .seed = 4, .sources = true}));
  const std::size_t n = problem.rhs->size();
  const auto y1 = wave(n, 0.1), y2 = wave(n, 1.1), y0 = wave(n, 2.1), f0 = wave(n, 3.1);
  const auto f = derivative(problem, y1);
  std::vector<double> out = y2;  // the result may overwrite y2
  problem.rhs->stage(0,
                     {.y1 = y1.data(),
                      .a = 0.7,
                      .d = 0.3,
                      .y2 = out.data(),
                      .b = -0.4,
                      .y0 = y0.data(),
                      .c = 0.2,
                      .f0 = f0.data(),
                      .e = 0.9},
                     out);
  for (std::size_t k = 0; k < n; ++k)
    EXPECT_NEAR(out[k], 0.7 * y1[k] - 0.4 * y2[k] + 0.2 * y0[k] + 0.3 * f[k] + 0.9 * f0[k], 1e-12 * 100);
}

TEST(NetworkRhs, LinearStageLeavesOutWhatDoesNotDependOnY) {
  Problem problem(random_graph({.nodes = 40, .seed = 6, .sources = true}));
  const auto y = wave(problem.rhs->size(), 0.5);
  std::vector<double> f(y.size()), jv(y.size()), f_zero(y.size());
  const std::vector<double> zero(y.size(), 0.0);
  (*problem.rhs)(0, y, f);
  (*problem.rhs)(0, zero, f_zero);
  problem.rhs->linear_stage({.y1 = y.data(), .a = 0, .d = 1}, jv);
  for (std::size_t k = 0; k < y.size(); ++k) EXPECT_NEAR(jv[k], f[k] - f_zero[k], 1e-12 * 100);
}

TEST(NetworkRhs, JacobianMatchesFiniteDifferences) {
  Problem problem(random_graph({.nodes = 40, .seed = 5, .contrast = 100, .fixed = 3}));
  auto& rhs = *problem.rhs;
  const std::size_t n = rhs.size();
  const auto& pattern = rhs.pattern();
  std::vector<double> values(pattern.row.size());
  auto y = wave(n, 0.2);
  rhs.jacobian(0, y, values);
  std::vector<double> plus(n), minus(n);
  for (std::size_t j = 0; j < n; ++j) {
    constexpr double step = 1e-3;  // f is linear: any step is exact up to rounding
    const double centre = y[j];
    y[j] = centre + step;
    rhs(0, y, plus);
    y[j] = centre - step;
    rhs(0, y, minus);
    y[j] = centre;
    std::vector<double> column(n, 0.0);
    for (auto k = pattern.column_begin[j]; k < pattern.column_begin[j + 1]; ++k)
      column[static_cast<std::size_t>(pattern.row[static_cast<std::size_t>(k)])] =
          values[static_cast<std::size_t>(k)];
    EXPECT_EQ(pattern.row[static_cast<std::size_t>(pattern.diagonal[j])], static_cast<std::int64_t>(j));
    for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR((plus[i] - minus[i]) / (2 * step), column[i], 1e-8);
  }
}

double true_radius(const Problem& problem) {
  const auto n = static_cast<Eigen::Index>(problem.rhs->size());
  const auto dense = problem.dense_matrix();
  const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> a(
      dense.data(), n, n);
  return a.eigenvalues().cwiseAbs().maxCoeff();
}

TEST(SpectralBounds, AreNeverBelowTheTrueRadius) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Problem problem(random_graph({.nodes = 25, .seed = seed, .contrast = 1e4, .fixed = seed % 4}));
    const double radius = true_radius(problem);
    const auto bounds = spectral_bounds(problem.rhs->network());
    EXPECT_GE(bounds.edge, radius * (1 - 1e-12));
    EXPECT_GE(bounds.gershgorin, radius * (1 - 1e-12));
    EXPECT_LE(bounds.smallest(), 2.5 * radius);
    const auto estimate = estimate_spectral_radius(*problem.rhs);
    EXPECT_NEAR(estimate.largest, radius, 0.01 * radius);
    EXPECT_GE(estimate.safe(bounds.smallest()), radius * (1 - 1e-12));
  }
}

/// A chain's largest eigenvalues lie close together: the search goes on until its space is whole.
TEST(SpectralBounds, AreFoundOnChains) {
  constexpr std::size_t nodes = 101;  // 99 of them are free
  Problem problem(test::chain(nodes, 0.0, 1.0));
  const auto estimate =
      estimate_spectral_radius(*problem.rhs, {.tolerance = 1e-12, .fewest = 20, .most = 200});
  const double half_wave = std::sin(0.5 * std::numbers::pi * 99 / 100);
  EXPECT_NEAR(estimate.largest, 4 * half_wave * half_wave, 1e-9);  // Ritz values err by the residual's square
}

/// One contact twelve decades stiffer than all others: nothing of its eigenvector is left in the last
/// vectors.
TEST(SpectralBounds, AreFoundAtOnceWhereOneContactIsStiff) {
  Graph graph = test::chain(200, 0.0, 1.0);
  graph.conductance[100] = 1e12;
  Problem problem(graph);
  const LanczosLimits limits;
  const auto estimate = estimate_spectral_radius(*problem.rhs, limits);
  EXPECT_EQ(estimate.products, limits.fewest);
  EXPECT_NEAR(estimate.largest, 2e12, 4);  // two equal nodes: twice the contact, and 1 of either neighbour
  EXPECT_LT(estimate.residual, 1);
}

TEST(SpectralBounds, ALoneNodeWithFixedNeighbours) {
  Problem problem(test::chain(3, 0.0, 1.0));  // one free node between two fixed ones: A = 2
  const auto bounds = spectral_bounds(problem.rhs->network());
  EXPECT_DOUBLE_EQ(bounds.smallest(), 2.0);
}

TEST(NetworkRhs, UniformStateHasExactlyNoDerivative) {
  Graph graph = random_graph({.nodes = 60, .seed = 9, .contrast = 1e6, .fixed = 3});
  for (auto& value : graph.fixed_value) value = 0.1;
  Problem problem(graph);
  const std::vector<double> y(problem.rhs->size(), 0.1);
  std::vector<double> f(y.size());
  (*problem.rhs)(0, y, f);
  for (const double value : f) EXPECT_EQ(value, 0.0);
  EXPECT_EQ(problem.rhs->inflow(0, y), 0.0);
}

TEST(NetworkRhs, InflowIsTheSumOfCapacityTimesRate) {
  Problem problem(random_graph({.nodes = 60, .seed = 8, .fixed = 4, .sources = true}));
  const auto y = wave(problem.rhs->size(), 0.7);
  std::vector<double> f(y.size());
  (*problem.rhs)(0, y, f);
  double sum = 0;
  for (std::size_t k = 0; k < f.size(); ++k) sum += problem.rhs->capacities()[k] * f[k];
  EXPECT_NEAR(problem.rhs->inflow(0, y), sum, 1e-10);
}

TEST(Reduction, SumsLikeAnObviousLoopAndSeesNan) {
  for (const std::size_t n :
       {std::size_t{0}, std::size_t{1}, std::size_t{7}, std::size_t{1024}, std::size_t{10007}}) {
    const Reduction reduction(n);
    EXPECT_NEAR(reduction.sum([](std::size_t i) { return static_cast<double>(i) * 0.5; }),
                0.25 * static_cast<double>(n) * (static_cast<double>(n) - 1.0 * (n > 0)), 1e-6);
  }
  const Reduction reduction(3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(reduction.max([&](std::size_t i) { return i == 1 ? nan : 5.0; })));
  EXPECT_EQ(reduction.max([](std::size_t i) { return static_cast<double>(i); }), 2.0);
}

}  // namespace
}  // namespace superstep
