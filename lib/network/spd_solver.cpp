#include "network/spd_solver.hpp"

#include <cholmod.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"

namespace superstep {
namespace {

std::size_t at(std::int32_t k) noexcept {
  return static_cast<std::size_t>(k);
}

}  // namespace

struct SpdSolver::Factor {
  Factor() { cholmod_l_start(&common); }
  ~Factor() {
    cholmod_l_free_sparse(&matrix, &common);
    cholmod_l_free_factor(&factor, &common);
    cholmod_l_finish(&common);
  }
  Factor(const Factor&) = delete;
  Factor& operator=(const Factor&) = delete;

  cholmod_common common{};
  cholmod_sparse* matrix = nullptr;
  cholmod_factor* factor = nullptr;
  std::size_t fill = 0;
};

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

SpdSolver::SpdSolver(const Network& network, double shift) : factor_(std::make_unique<Factor>()) {
  if (!(shift > 0) && !every_component_is_held(network))
    throw NumericalError("a part of the network touches no fixed node, so its steady state is not unique");
  auto& common = factor_->common;
  common.print = 0;
  const std::size_t n = network.size();
  factor_->matrix =
      cholmod_l_allocate_sparse(n, n, network.nonzeros() / 2 + n, 1, 1, 1, CHOLMOD_REAL, &common);
  if (!factor_->matrix) throw NumericalError("out of memory for the network matrix");
  fill_values(network, shift);
  factor_->factor = cholmod_l_analyze(factor_->matrix, &common);
  factorize();
}

/// Upper triangle by columns: row j of the network holds column j, since the matrix is symmetric.
void SpdSolver::fill_values(const Network& network, double shift) {
  auto* begin = static_cast<SuiteSparse_long*>(factor_->matrix->p);
  auto* row = static_cast<SuiteSparse_long*>(factor_->matrix->i);
  auto* value = static_cast<double*>(factor_->matrix->x);
  const auto total = network.total_conductance();
  SuiteSparse_long out = 0;
  for (std::size_t j = 0; j < network.size(); ++j) {
    begin[j] = out;
    for (auto k = network.row_begin[j]; k < network.row_begin[j + 1]; ++k) {
      const auto i = network.column[static_cast<std::size_t>(k)];
      if (at(i) > j) break;
      row[out] = i;
      value[out++] = -network.conductance[static_cast<std::size_t>(k)];
    }
    row[out] = static_cast<SuiteSparse_long>(j);
    value[out++] = total[j] + shift * network.capacity[j];
  }
  begin[network.size()] = out;
}

void SpdSolver::factorize() {
  auto& common = factor_->common;
  if (factor_->factor) cholmod_l_factorize(factor_->matrix, factor_->factor, &common);
  if (!factor_->factor || common.status != CHOLMOD_OK)
    throw NumericalError(
        fmt::format("the network matrix could not be factorized (CHOLMOD status {})", common.status));
  factor_->fill = static_cast<std::size_t>(common.lnz);
}

void SpdSolver::refactorize(const Network& network, double shift) {
  fill_values(network, shift);
  factorize();
}

SpdSolver::~SpdSolver() = default;

std::size_t SpdSolver::fill() const noexcept {
  return factor_->fill;
}

std::vector<double> SpdSolver::solve(std::span<const double> b) const {
  std::vector<double> copy(b.begin(), b.end());
  cholmod_dense right{};
  right.nrow = right.d = right.nzmax = copy.size();
  right.ncol = 1;
  right.x = copy.data();
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  cholmod_dense* x = cholmod_l_solve(CHOLMOD_A, factor_->factor, &right, &factor_->common);
  if (!x) throw NumericalError("the network could not be solved: out of memory");
  std::copy_n(static_cast<const double*>(x->x), copy.size(), copy.begin());
  cholmod_l_free_dense(&x, &factor_->common);
  return copy;
}

std::vector<double> steady_state(const Network& network) {
  std::vector<double> load = network.source;
  for (const auto& edge : network.ghost_edges)
    load[at(edge.row)] += edge.conductance * network.ghost_value[at(edge.ghost)];
  return SpdSolver(network).solve(load);
}

}  // namespace superstep
