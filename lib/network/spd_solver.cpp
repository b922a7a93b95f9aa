#include "network/spd_solver.hpp"

#include <algorithm>
#include <new>
#include <utility>

#include "core/error.hpp"
#include "core/index.hpp"

namespace superstep {

bool every_component_is_held(const Network& network) {
  std::vector<char> held(network.size(), 0);
  std::vector<std::int32_t> frontier;
  const auto hold = [&](std::int32_t row) {
    if (std::exchange(held[at(row)], 1) == 0) frontier.push_back(row);
  };
  for (const auto& edge : network.ghost_edges) hold(edge.row);
  while (!frontier.empty()) {
    const auto row = at(frontier.back());
    frontier.pop_back();
    for (auto k = network.row_begin[row]; k < network.row_begin[row + 1]; ++k)
      hold(network.column[static_cast<std::size_t>(k)]);
  }
  return std::all_of(held.begin(), held.end(), [](char h) { return h != 0; });
}

SpdSolver::SpdSolver(const Network& network, double shift) {
  if (!(shift > 0) && !every_component_is_held(network))
    throw NumericalError("a part of the network touches no fixed node, so its steady state is not unique");
  // Row j of the network holds column j, since the matrix is symmetric.
  std::vector<std::int64_t> column_begin{0}, row;
  row.reserve(network.nonzeros() / 2 + network.size());
  for (std::size_t j = 0; j < network.size(); ++j) {
    for (auto k = network.row_begin[j]; k < network.row_begin[j + 1]; ++k)
      if (const auto i = network.column[static_cast<std::size_t>(k)]; at(i) < j) row.push_back(i);
    row.push_back(static_cast<std::int64_t>(j));
    column_begin.push_back(static_cast<std::int64_t>(row.size()));
  }
  factor_ = std::make_unique<CholmodFactor>(column_begin, row);
  refactorize(network, shift);
}

void SpdSolver::refactorize(const Network& network, double shift) {
  const auto total = network.total_conductance();
  const auto value = factor_->values();
  std::size_t out = 0;
  for (std::size_t j = 0; j < network.size(); ++j) {
    for (auto k = static_cast<std::size_t>(network.row_begin[j]);
         k < static_cast<std::size_t>(network.row_begin[j + 1]); ++k)
      if (at(network.column[k]) < j) value[out++] = -network.conductance[k];
    value[out++] = total[j] + shift * network.capacity[j];
  }
  bool definite = false;
  try {
    definite = factor_->factorize();
  } catch (const std::bad_alloc&) {  // of this matrix alone: whoever can do without it goes on
    throw NumericalError("the network matrix could not be factorized: out of memory");
  }
  if (!definite)
    throw NumericalError("the network matrix could not be factorized: it is not positive definite");
}

std::vector<double> SpdSolver::solve(std::span<const double> b) const {
  std::vector<double> x(b.size());
  if (x.empty()) return x;  // CHOLMOD fails on a matrix without rows
  if (!factor_->solve(b, x)) throw NumericalError("the network could not be solved: out of memory");
  return x;
}

std::vector<double> steady_state(const Network& network) {
  if (network.size() == 0) return {};  // CHOLMOD fails on a matrix without rows
  std::vector<double> load = network.source;
  for (const auto& edge : network.ghost_edges)
    load[at(edge.row)] += edge.conductance * network.ghost_value[at(edge.ghost)];
  return SpdSolver(network).solve(load);
}

}  // namespace superstep
