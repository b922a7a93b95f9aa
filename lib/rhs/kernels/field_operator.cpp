#include "rhs/kernels/field_operator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/index.hpp"
#include "core/memory.hpp"
#include "rhs/kernels/sweep.hpp"

namespace superstep {
namespace {

double fourth_power(double x) noexcept {
  return (x * x) * (x * x);
}

/// Those of a list sorted by row that act on rows [first, last).
template <class Entry>
std::span<const Entry> in_rows(const std::vector<Entry>& sorted, std::size_t first, std::size_t last) {
  const auto from = [&](std::size_t row) {
    return std::lower_bound(sorted.begin(), sorted.end(), row,
                            [](const Entry& entry, std::size_t bound) { return at(entry.row) < bound; });
  };
  return {from(first), from(last)};
}

}  // namespace

SpectralBounds spectral_bounds(const Network& network) {
  const std::size_t n = network.size();
  std::vector<double> rate(n + (network.halo ? network.halo->size() : 0));
  SpectralBounds bounds;
  auto edge = network.ghost_edges.begin();  // they are sorted by row
  for (std::size_t i = 0; i < n; ++i) {
    double ghost = 0;
    for (; edge != network.ghost_edges.end() && at(edge->row) == i; ++edge) ghost += edge->conductance;
    double total = ghost;
    for (auto k = network.row_begin[i]; k < network.row_begin[i + 1]; ++k)
      total += network.conductance[at(k)];
    rate[i] = total / network.capacity[i];
    bounds.gershgorin = std::max(bounds.gershgorin, (2 * total - ghost) / network.capacity[i]);
  }
  if (network.halo) network.halo->fetch(rate.data(), rate.data() + n);
  for (std::size_t i = 0; i < n; ++i) {
    bounds.edge = std::max(bounds.edge, rate[i]);
    for (auto k = network.row_begin[i]; k < network.row_begin[i + 1]; ++k)
      bounds.edge = std::max(bounds.edge, rate[i] + rate[at(network.column[at(k)])]);
  }
  if (auto* among = network.among()) bounds = {among->max(bounds.edge), among->max(bounds.gershgorin)};
  return bounds;
}

FieldOperator::FieldOperator(Network network, bool keep_network)
    : network_(std::move(network)),
      boundary_(network_.halo ? std::make_unique<BoundaryRows>(network_) : nullptr),
      rate_(boundary_ ? boundary_->interior_rows(network_) : SlicedRows(network_.row_begin, network_.column)),
      ghost_value_(network_.ghost_value),
      inputs_(network_.tables) {
  facts_.nonzeros = network_.nonzeros();
  if (!keep_network) free_list(network_.column);  // before values take their room
  set_conductances(network_.conductance, {});
  if (!keep_network) forget_pattern();
  for (std::size_t i = 0; i < size(); ++i)
    if (network_.source[i] != 0)
      sources_.push_back({static_cast<std::int32_t>(i), network_.source[i] / network_.capacity[i]});
  for (const auto& source : network_.tabled_sources) tabled_.push_back({source.node, source.table});
  std::stable_sort(tabled_.begin(), tabled_.end(),
                   [](const TabledRate& a, const TabledRate& b) { return a.row < b.row; });
  constant_ghosts_ = std::all_of(network_.ghost_table.begin(), network_.ghost_table.end(),
                                 [](std::int32_t table) { return table < 0; });
  constant_inputs_ = network_.inputs_are_constant();
  for (const auto& exchange : network_.radiation)
    radiation_.push_back({exchange.node, exchange.table,
                          exchange.coefficient / network_.capacity[at(exchange.node)],
                          fourth_power(exchange.ambient)});
  find_facts();
}

void FieldOperator::set_conductances(std::span<const double> edges, std::span<const double> ghost_edges) {
  if (edges.data() != network_.conductance.data())
    std::copy(edges.begin(), edges.end(), network_.conductance.begin());
  for (std::size_t k = 0; k < ghost_edges.size(); ++k) network_.ghost_edges[k].conductance = ghost_edges[k];
  const auto rate = [this](std::size_t row, std::size_t k) {
    return network_.conductance[k] / network_.capacity[row];
  };
  if (boundary_) {
    const auto begin = boundary_->interior_begin();
    boundary_->set_values(network_, rate);
    rate_.set_values(begin, [&](std::size_t row, std::size_t k) {
      return rate(row, at(network_.row_begin[row]) + k - at(begin[row]));
    });
  } else {
    rate_.set_values(network_.row_begin, rate);
  }
  forget_flanks();
  ghosts_.clear();
  for (const auto& edge : network_.ghost_edges)
    ghosts_.push_back({edge.row, edge.ghost, edge.conductance / network_.capacity[at(edge.row)]});
}

void FieldOperator::forget_pattern() {
  free_list(network_.row_begin);
  free_list(network_.conductance);
  if (boundary_) boundary_->forget_pattern();
}

void FieldOperator::set_ghost_conductances(std::span<const std::int32_t> edges,
                                           std::span<const double> conductance) {
  forget_flanks();
  for (const auto e : edges) {
    auto& edge = network_.ghost_edges[at(e)];
    edge.conductance = conductance[at(e)];
    ghosts_[at(e)].rate = edge.conductance / network_.capacity[at(edge.row)];
  }
}

std::span<const double> FieldOperator::ghost_values(double t) {
  if (!constant_ghosts_ && (t != ghost_time_ || !ghosts_are_current_)) {
    for (std::size_t g = 0; g < ghost_value_.size(); ++g)
      if (const auto table = network_.ghost_table[g]; table >= 0) ghost_value_[g] = inputs_.at(at(table), t);
    ghost_time_ = t;
    ghosts_are_current_ = true;
  }
  return ghost_value_;
}

void FieldOperator::enter(double begin, double end) noexcept {
  inputs_.enter(begin, end);
  ghosts_are_current_ = false;
}

void FieldOperator::leave() noexcept {
  inputs_.leave();
  ghosts_are_current_ = false;
}

double FieldOperator::ambient4(const RadiationRate& radiation, double t) const noexcept {
  return radiation.table < 0 ? radiation.ambient4 : fourth_power(inputs_.at(at(radiation.table), t));
}

void FieldOperator::add_inputs(double t, const Stage& stage, std::size_t first, std::size_t last,
                               double* out) const {
  for (const auto& ghost : in_rows(ghosts_, first, last))
    out[at(ghost.row)] += stage.d * ghost.rate * (ghost_value_[at(ghost.ghost)] - stage.y1[ghost.row]);
  for (const auto& source : in_rows(sources_, first, last)) out[at(source.row)] += stage.d * source.rate;
  for (const auto& source : in_rows(tabled_, first, last))
    out[at(source.row)] += stage.d * inputs_.at(at(source.table), t) / network_.capacity[at(source.row)];
  for (const auto& radiation : in_rows(radiation_, first, last))
    out[at(radiation.row)] +=
        stage.d * radiation.rate * (ambient4(radiation, t) - fourth_power(stage.y1[radiation.row]));
}

void FieldOperator::stage(double t, const Stage& stage, double* out) {
  (void)ghost_values(t);
  sweep_all(stage, out, [&](std::size_t first, std::size_t last) { add_inputs(t, stage, first, last, out); });
}

void FieldOperator::varying_stage(double t, ConductanceMean mean, const SlicedRows& geometry,
                                  const NodePair* nodes, const Stage& stage, double* out) {
  (void)ghost_values(t);
  for_slices(geometry, [&](std::size_t first, std::size_t last) {
    varying_sweep(mean, geometry, nodes, stage, first, last, out);
    add_inputs(t, stage, first * SlicedRows::lanes, last * SlicedRows::lanes, out);
  });
}

void FieldOperator::conduction_stage(const Stage& stage, double* out) const {
  sweep_all(stage, out, [&](std::size_t first, std::size_t last) {
    for (const auto& ghost : in_rows(ghosts_, first, last))
      out[at(ghost.row)] -= stage.d * ghost.rate * stage.y1[ghost.row];
  });
}

double FieldOperator::inflow(double t, std::span<const double> y) {
  (void)ghost_values(t);
  RowInflow sum;
  add_inflow(t, y.data(), 0, size(), sum);
  return total_inflow(t, sum);
}

void FieldOperator::add_inflow(double t, const double* y, std::size_t first, std::size_t last,
                               RowInflow& sum) const {
  for (const auto& edge : in_rows(network_.ghost_edges, first, last))
    sum.exchanged.add(at(edge.row), edge.conductance * (ghost_value_[at(edge.ghost)] - y[edge.row]));
  for (const auto& radiation : in_rows(radiation_, first, last))
    sum.radiated.add(at(radiation.row), radiation.rate * network_.capacity[at(radiation.row)] *
                                            (ambient4(radiation, t) - fourth_power(y[radiation.row])));
}

double FieldOperator::total_inflow(double t, RowInflow& sum) const {
  RowSum supplied, tabled;
  for (const auto& source : sources_)
    supplied.add(at(source.row), source.rate * network_.capacity[at(source.row)]);
  for (const auto& source : tabled_) tabled.add(at(source.row), inputs_.at(at(source.table), t));
  ExactSum all = sum.exchanged.exact();
  for (auto* part : {&sum.radiated, &supplied, &tabled}) all.add(part->exact());
  return network_.among() ? network_.among()->sum(all) : all.value();
}

double FieldOperator::conduction_inflow(std::span<const double> v) const {
  RowSum sum;
  for (const auto& edge : network_.ghost_edges) sum.add(at(edge.row), -edge.conductance * v[at(edge.row)]);
  return network_.among() ? network_.among()->sum(sum.exact()) : sum.exact().value();
}

std::optional<std::string> FieldOperator::radiation_violation(std::span<const double> y, double slack) const {
  // Up to there T^4 is nothing beside that of the surroundings, and a method may pass below for a moment.
  constexpr double share = 0.1, least = 10;  // K
  const double depth = std::max({slack, share * facts_.ambient.magnitude(), least});
  for (const auto& radiation : radiation_) {
    const double temperature = y[at(radiation.row)];
    if (temperature < -depth)
      return fmt::format(
          "the temperature of a node that radiates has reached {:.6g} K, and radiation needs temperatures "
          ">= 0 K; either a source takes more heat than there is, or steps are too long for the method",
          temperature);
  }
  return std::nullopt;
}

double FieldOperator::radiation_slope(std::span<const double> y) const {
  double largest = 0;
  for (const auto& radiation : radiation_) {
    const double magnitude = std::abs(y[at(radiation.row)]);
    largest = std::max(largest, 4 * radiation.rate * magnitude * magnitude * magnitude);
  }
  if (auto* among = network_.among()) largest = among->max(largest);
  return largest;
}

}  // namespace superstep
