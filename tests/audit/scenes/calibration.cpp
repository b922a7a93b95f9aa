#include "audit/scenes/calibration.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/index.hpp"

namespace superstep::audit {
namespace {

/// K of all nodes; fixed nodes become rows that hold 0.
Eigen::MatrixXd stiffness(const Graph& graph) {
  const auto n = static_cast<Eigen::Index>(graph.nodes());
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t e = 0; e < graph.edges(); ++e) {
    const Eigen::Index i = graph.i[e], j = graph.j[e];
    k(i, i) += graph.conductance[e];
    k(j, j) += graph.conductance[e];
    k(i, j) -= graph.conductance[e];
    k(j, i) -= graph.conductance[e];
  }
  for (const auto& exchange : graph.convection) k(exchange.node, exchange.node) += exchange.coefficient;
  return k;
}

void hold_fixed(const Graph& graph, Eigen::MatrixXd& matrix, Eigen::VectorXd& right) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    if (!graph.is_fixed[static_cast<std::size_t>(i)]) continue;
    matrix.row(i).setZero();
    matrix(i, i) = 1;
    right(i) = 0;
  }
}

}  // namespace

double radius_bound(const Graph& graph, double hottest) {
  std::vector<double> row(graph.nodes(), 0.0);
  for (std::size_t e = 0; e < graph.edges(); ++e)
    for (const auto node : {graph.i[e], graph.j[e]}) row[at(node)] += 2 * graph.conductance[e];
  for (const auto& exchange : graph.convection) row[at(exchange.node)] += exchange.coefficient;
  for (const auto& exchange : graph.radiation)
    row[at(exchange.node)] += 4 * exchange.coefficient * hottest * hottest * hottest;
  double bound = 0;
  for (std::size_t node = 0; node < row.size(); ++node)
    if (!graph.is_fixed[node]) bound = std::max(bound, row[node] / graph.capacity[node]);
  return bound;
}

double rise_of(const Graph& graph, const std::vector<double>& heat, double duration) {
  const auto n = static_cast<Eigen::Index>(graph.nodes());
  const Eigen::MatrixXd k = stiffness(graph);
  Eigen::VectorXd rise = Eigen::VectorXd::Zero(n);
  double largest = 0, step = 1e-3 * duration, t = 0;
  while (t < duration) {  // backward Euler with growing steps
    step = std::min(step, duration - t);
    Eigen::MatrixXd matrix = step * k;
    Eigen::VectorXd right(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto node = static_cast<std::size_t>(i);
      matrix(i, i) += graph.capacity[node];
      right(i) = graph.capacity[node] * rise(i) + step * heat[node];
    }
    hold_fixed(graph, matrix, right);
    rise = matrix.partialPivLu().solve(right);
    largest = std::max(largest, rise.cwiseAbs().maxCoeff());
    t += step;
    step *= 3;
  }
  return largest;
}

std::vector<double> steady_joule_heat(const Graph& electric, const ConductionLaws& laws,
                                      const std::vector<double>& fixed, const std::vector<double>& source) {
  const auto n = static_cast<Eigen::Index>(electric.nodes());
  Eigen::MatrixXd matrix = stiffness(electric);
  Eigen::VectorXd right(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto node = static_cast<std::size_t>(i);
    right(i) = source[node];
    if (matrix(i, i) > 0) matrix(i, i) *= 1 + 1e-13;  // holds pieces without an electrode near 0
  }
  hold_fixed(electric, matrix, right);
  for (Eigen::Index i = 0; i < n; ++i)
    if (electric.is_fixed[static_cast<std::size_t>(i)]) right(i) = fixed[static_cast<std::size_t>(i)];
  for (Eigen::Index i = 0; i < n; ++i)
    if (matrix(i, i) == 0) matrix(i, i) = 1;
  const Eigen::VectorXd v = matrix.partialPivLu().solve(right);
  std::vector<double> heat(electric.nodes(), 0.0);
  for (std::size_t e = 0; e < electric.edges(); ++e) {
    const double dv = v(electric.j[e]) - v(electric.i[e]), power = electric.conductance[e] * dv * dv;
    const double a = laws.of_node(electric.i[e]).value, b = laws.of_node(electric.j[e]).value;
    heat[at(electric.i[e])] += power * b / (a + b);
    heat[at(electric.j[e])] += power * a / (a + b);
  }
  return heat;
}

}  // namespace superstep::audit
