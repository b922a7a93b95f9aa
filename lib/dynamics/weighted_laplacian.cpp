#include "dynamics/weighted_laplacian.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "core/index.hpp"
#include "network/graph.hpp"
#include "network/network.hpp"
#include "network/spd_solver.hpp"

namespace superstep::dynamics {
namespace {

std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t i) noexcept {
  while (parent[at(i)] != i) {
    parent[at(i)] = parent[at(parent[at(i)])];
    i = parent[at(i)];
  }
  return i;
}

}  // namespace

void WeightedLaplacian::find_reached(std::span<const WeightedEdge> edges, std::span<const char> fixed) {
  const std::size_t n = fixed.size();
  parent_.resize(n);
  std::iota(parent_.begin(), parent_.end(), 0);
  for (const auto& edge : edges) {
    const auto a = root_of(parent_, edge.i), b = root_of(parent_, edge.j);
    if (a != b) parent_[at(std::max(a, b))] = std::min(a, b);
  }
  reached_.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i)
    if (fixed[i]) reached_[at(root_of(parent_, static_cast<std::int32_t>(i)))] = 1;
  for (std::size_t i = 0; i < n; ++i)
    reached_[i] = reached_[at(root_of(parent_, static_cast<std::int32_t>(i)))];
}

void WeightedLaplacian::solve(std::span<const WeightedEdge> edges, std::span<const char> fixed,
                              std::span<double> x) {
  iterations_ = 0;
  find_reached(edges, fixed);
  const std::size_t n = fixed.size();
  unknown_.resize(n);
  bool any = false, first = true;
  double low = 0, high = 0;
  for (std::size_t i = 0; i < n; ++i) {
    unknown_[i] = reached_[i] && !fixed[i];
    any = any || unknown_[i];
    if (!reached_[i]) x[i] = 0;
    if (!fixed[i]) continue;
    low = first ? x[i] : std::min(low, x[i]);
    high = first ? x[i] : std::max(high, x[i]);
    first = false;
  }
  if (!any) return;
  if (low == high) {  // the maximum principle leaves nothing to compute
    for (std::size_t i = 0; i < n; ++i)
      if (unknown_[i]) x[i] = low;
    return;
  }
  if (solver_ == CurrentSolver::direct) return solve_direct(edges, fixed, x);
  // Only differences matter: a level that all share would hide them from the tolerance.
  shifted_.assign(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    if (reached_[i]) shifted_[i] = x[i] - low;
  if (solver_ == CurrentSolver::jacobi)
    solve_jacobi(edges, shifted_);
  else
    solve_conjugate(edges, shifted_);
  for (std::size_t i = 0; i < n; ++i)
    if (unknown_[i]) x[i] = low + shifted_[i];
}

void WeightedLaplacian::solve_jacobi(std::span<const WeightedEdge> edges, std::span<double> x) {
  constexpr int most_iterations = 1'000'000;
  const std::size_t n = x.size();
  diagonal_.assign(n, 0.0);
  for (const auto& edge : edges) {
    diagonal_[at(edge.i)] += edge.weight;
    diagonal_[at(edge.j)] += edge.weight;
  }
  double scale = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (reached_[i] && !unknown_[i]) scale = std::max(scale, std::abs(x[i]));
  for (iterations_ = 1; iterations_ <= most_iterations; ++iterations_) {
    product_.assign(n, 0.0);
    for (const auto& edge : edges) {
      product_[at(edge.i)] += edge.weight * x[at(edge.j)];
      product_[at(edge.j)] += edge.weight * x[at(edge.i)];
    }
    double change = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (!unknown_[i]) continue;
      const double mean = product_[i] / diagonal_[i];
      change = std::max(change, std::abs(mean - x[i]));
      x[i] = mean;
    }
    if (change <= tolerance_ * scale) return;
  }
  throw NumericalError(fmt::format(
      "the particle currents did not settle to {:.1e} in {} sweeps of Jacobi's method; take solver = "
      "\"conjugate\" or \"direct\" in [electric]",
      tolerance_, most_iterations));
}

// Conjugate gradients on the unknowns, preconditioned by the diagonal.
void WeightedLaplacian::solve_conjugate(std::span<const WeightedEdge> edges, std::span<double> x) {
  const std::size_t n = x.size();
  diagonal_.assign(n, 0.0);
  residual_.assign(n, 0.0);
  double scale = 0;  // what the fixed values alone put in
  product_.assign(n, 0.0);
  for (const auto& edge : edges) {
    const std::size_t i = at(edge.i), j = at(edge.j);
    diagonal_[i] += edge.weight;
    diagonal_[j] += edge.weight;
    const double flow = edge.weight * (x[j] - x[i]);
    residual_[i] += flow;
    residual_[j] -= flow;
    if (!unknown_[i]) product_[j] += edge.weight * x[i];
    if (!unknown_[j]) product_[i] += edge.weight * x[j];
  }
  preconditioned_.assign(n, 0.0);
  direction_.assign(n, 0.0);
  double rho = 0, norm = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (!unknown_[i]) continue;
    scale += product_[i] * product_[i] / diagonal_[i];
    direction_[i] = residual_[i] / diagonal_[i];
    rho += residual_[i] * direction_[i];
  }
  norm = rho;
  if (scale == 0) {  // they meet no fixed value but 0: what they hold from before has nothing to hold on to
    for (std::size_t i = 0; i < n; ++i)
      if (unknown_[i]) x[i] = 0;
    return;
  }
  const double limit = tolerance_ * tolerance_ * scale;
  const int most_iterations = 10 * static_cast<int>(n) + 100;
  while (norm > limit) {
    if (++iterations_ > most_iterations)
      throw NumericalError(fmt::format(
          "the particle currents did not settle to {:.1e} in {} iterations of conjugate gradients; take "
          "solver = \"direct\" in [electric]",
          tolerance_, most_iterations));
    std::fill(product_.begin(), product_.end(), 0.0);
    for (const auto& edge : edges) {
      const std::size_t i = at(edge.i), j = at(edge.j);
      const double flow = edge.weight * (direction_[i] - direction_[j]);
      product_[i] += flow;
      product_[j] -= flow;
    }
    double curvature = 0;
    for (std::size_t i = 0; i < n; ++i)
      if (unknown_[i]) curvature += direction_[i] * product_[i];
    const double alpha = rho / curvature;
    double next = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (!unknown_[i]) continue;
      x[i] += alpha * direction_[i];
      residual_[i] -= alpha * product_[i];
      preconditioned_[i] = residual_[i] / diagonal_[i];
      next += residual_[i] * preconditioned_[i];
    }
    const double beta = next / rho;
    for (std::size_t i = 0; i < n; ++i)
      if (unknown_[i]) direction_[i] = preconditioned_[i] + beta * direction_[i];
    rho = norm = next;
  }
}

void WeightedLaplacian::solve_direct(std::span<const WeightedEdge> edges, std::span<const char> fixed,
                                     std::span<double> x) {
  const std::size_t n = x.size();
  Graph graph;
  graph.capacity.assign(n, 1.0);
  graph.source.assign(n, 0.0);
  graph.initial.assign(n, 0.0);
  graph.fixed_value.assign(x.begin(), x.end());
  graph.is_fixed.assign(fixed.begin(), fixed.end());
  std::vector<NodeRole> roles(n);
  for (std::size_t i = 0; i < n; ++i) {
    graph.id.push_back(static_cast<std::int64_t>(i));
    roles[i] = fixed[i] ? NodeRole::fixed : reached_[i] ? NodeRole::free : NodeRole::idle;
  }
  for (const auto& edge : edges) {
    graph.i.push_back(edge.i);
    graph.j.push_back(edge.j);
    graph.conductance.push_back(edge.weight);
  }
  const Network network = build_network(graph, roles);
  const std::vector<double> values = steady_state(network);
  for (std::size_t row = 0; row < values.size(); ++row) x[at(network.node_of_row[row])] = values[row];
}

}  // namespace superstep::dynamics
