#include "rhs/network_rhs.hpp"

#include <algorithm>
#include <cmath>

#include "rhs/sweep.hpp"

namespace superstep {
namespace {

std::size_t at(std::int32_t k) noexcept {
  return static_cast<std::size_t>(k);
}
std::size_t at(std::int64_t k) noexcept {
  return static_cast<std::size_t>(k);
}

}  // namespace

SpectralBounds spectral_bounds(const Network& network) {
  const auto total = network.total_conductance(), ghost = network.ghost_conductance();
  SpectralBounds bounds;
  for (std::size_t i = 0; i < network.size(); ++i) {
    const double capacity = network.capacity[i];
    bounds.gershgorin = std::max(bounds.gershgorin, (2 * total[i] - ghost[i]) / capacity);
    bounds.edge = std::max(bounds.edge, total[i] / capacity);
    for (auto k = network.row_begin[i]; k < network.row_begin[i + 1]; ++k) {
      const auto j = at(network.column[at(k)]);
      bounds.edge = std::max(bounds.edge, total[i] / capacity + total[j] / network.capacity[j]);
    }
  }
  return bounds;
}

NetworkRhs::NetworkRhs(Network network, std::string field_name, std::string unit, double pair_step)
    : Rhs(network.size(), {.linear = true, .constant_jacobian = true, .symmetric = true, .autonomous = true},
          {FieldView{std::move(field_name), std::move(unit), 0, 1, network.size()}}),
      network_(std::move(network)),
      pair_step_(pair_step),
      bound_(spectral_bounds(network_).smallest()),
      rate_(network_.nonzeros()) {
  for (std::size_t i = 0; i < size(); ++i)
    for (auto k = network_.row_begin[i]; k < network_.row_begin[i + 1]; ++k)
      rate_[at(k)] = network_.conductance[at(k)] / network_.capacity[i];
  for (const auto& edge : network_.ghost_edges)
    ghosts_.push_back({edge.row, edge.ghost, edge.conductance / network_.capacity[at(edge.row)]});
  for (std::size_t i = 0; i < size(); ++i)
    if (network_.source[i] != 0)
      sources_.push_back({static_cast<std::int32_t>(i), network_.source[i] / network_.capacity[i]});
}

void NetworkRhs::do_stage(double /*t*/, const Stage& stage, std::span<double> out) {
  fused_sweep({network_.row_begin, network_.column, rate_}, stage, out.data());
  for (const auto& ghost : ghosts_)
    out[at(ghost.row)] +=
        stage.d * ghost.rate * (network_.ghost_value[at(ghost.ghost)] - stage.y1[ghost.row]);
  for (const auto& source : sources_) out[at(source.row)] += stage.d * source.rate;
}

void NetworkRhs::do_linear_stage(const Stage& stage, std::span<double> out) {
  fused_sweep({network_.row_begin, network_.column, rate_}, stage, out.data());
  for (const auto& ghost : ghosts_) out[at(ghost.row)] -= stage.d * ghost.rate * stage.y1[ghost.row];
}

SparsePattern NetworkRhs::build_pattern() const {
  SparsePattern pattern;
  pattern.column_begin.push_back(0);
  for (std::size_t j = 0; j < size(); ++j) {
    const auto column = static_cast<std::int64_t>(j);
    bool placed = false;
    const auto place_diagonal = [&] {
      pattern.diagonal.push_back(static_cast<std::int64_t>(pattern.row.size()));
      pattern.row.push_back(column);
      placed = true;
    };
    for (auto k = network_.row_begin[j]; k < network_.row_begin[j + 1]; ++k) {
      const std::int64_t row = network_.column[at(k)];
      if (!placed && row > column) place_diagonal();
      pattern.row.push_back(row);
    }
    if (!placed) place_diagonal();
    pattern.column_begin.push_back(static_cast<std::int64_t>(pattern.row.size()));
  }
  return pattern;
}

void NetworkRhs::do_jacobian(double /*t*/, std::span<const double> /*y*/, std::span<double> values) {
  const auto total = network_.total_conductance();
  std::size_t out = 0;
  for (std::size_t j = 0; j < size(); ++j) {
    bool placed = false;
    const auto place_diagonal = [&] {
      values[out++] = -total[j] / network_.capacity[j];
      placed = true;
    };
    for (auto k = network_.row_begin[j]; k < network_.row_begin[j + 1]; ++k) {
      const auto i = at(network_.column[at(k)]);
      if (!placed && i > j) place_diagonal();
      values[out++] = network_.conductance[at(k)] / network_.capacity[i];
    }
    if (!placed) place_diagonal();
  }
}

double NetworkRhs::spectral_bound(double /*t*/, std::span<const double> /*y*/) const {
  return bound_;
}

double NetworkRhs::inflow(double /*t*/, std::span<const double> y) const {
  double sum = 0;
  for (const auto& edge : network_.ghost_edges)
    sum += edge.conductance * (network_.ghost_value[at(edge.ghost)] - y[at(edge.row)]);
  for (const auto& source : sources_) sum += source.rate * network_.capacity[at(source.row)];
  return sum;
}

double NetworkRhs::linear_inflow(std::span<const double> v) const {
  double sum = 0;
  for (const auto& edge : network_.ghost_edges) sum -= edge.conductance * v[at(edge.row)];
  return sum;
}

double NetworkRhs::source_rate() const {
  double largest = 0;
  for (const auto& source : sources_) largest = std::max(largest, std::abs(source.rate));
  return largest;
}

}  // namespace superstep
