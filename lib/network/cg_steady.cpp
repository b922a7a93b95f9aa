#include "network/cg_steady.hpp"

#include <array>
#include <cmath>

#include "core/index.hpp"
#include "parallel/reduction.hpp"

namespace superstep {
namespace {

/// x holds the rows that are here and room for the halo behind them.
void multiply(const Network& network, const std::vector<double>& diagonal, std::vector<double>& x,
              std::vector<double>& out) {
  if (network.halo) network.halo->fetch(x.data(), x.data() + network.size());
  for (std::size_t i = 0; i < network.size(); ++i) {
    double sum = diagonal[i] * x[i];
    for (auto k = network.row_begin[i]; k < network.row_begin[i + 1]; ++k) {
      const auto e = static_cast<std::size_t>(k);
      sum -= network.conductance[e] * x[at(network.column[e])];
    }
    out[i] = sum;
  }
}

}  // namespace

std::vector<double> approximate_steady_state(const Network& network, double tolerance) {
  constexpr int most_iterations = 20'000;
  const std::size_t n = network.size();
  const Reduction reduction(std::array{n}, network.all_rows(), network.among());
  const auto dot = [&](const std::vector<double>& a, const std::vector<double>& b) {
    return reduction.sum([&](std::size_t i) { return a[i] * b[i]; });
  };
  const auto diagonal = network.total_conductance();
  std::vector<double> x(n, 0.0), residual = network.source, image(n), preconditioned(n);
  for (const auto& edge : network.ghost_edges)
    residual[at(edge.row)] += edge.conductance * network.ghost_value[at(edge.ghost)];
  const auto precondition = [&] {
    for (std::size_t i = 0; i < n; ++i) preconditioned[i] = diagonal[i] > 0 ? residual[i] / diagonal[i] : 0;
  };
  const double target = tolerance * std::sqrt(dot(residual, residual));
  precondition();
  std::vector<double> direction = preconditioned;
  direction.resize(n + (network.halo ? network.halo->size() : 0));
  double rz = dot(residual, preconditioned);
  for (int k = 0; k < most_iterations && std::sqrt(dot(residual, residual)) > target; ++k) {
    multiply(network, diagonal, direction, image);
    const double curvature = dot(direction, image);
    if (!(curvature > 0)) break;  // a floating part with a source: it has no steady state
    const double alpha = rz / curvature;
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += alpha * direction[i];
      residual[i] -= alpha * image[i];
    }
    precondition();
    const double next = dot(residual, preconditioned), beta = next / rz;
    rz = next;
    for (std::size_t i = 0; i < n; ++i) direction[i] = preconditioned[i] + beta * direction[i];
  }
  if (n > 0 && !(std::sqrt(dot(residual, residual)) <= target)) return {};
  return x;
}

}  // namespace superstep
