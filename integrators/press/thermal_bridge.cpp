#include "integrators/press/thermal_bridge.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "core/stopwatch.hpp"
#include "integrators/registry.hpp"
#include "rhs/network_rhs.hpp"

namespace superstep::dynamics {
namespace {

/// Pairwise critical step of a network [s]; infinity without edges (Rojek & Nisar 2026, eqs 27-29).
double pair_step(const Network& network) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t row = 0; row < network.size(); ++row)
    for (auto k = network.row_begin[row]; k < network.row_begin[row + 1]; ++k) {
      const double c_i = network.capacity[row];
      const double c_j =
          network.capacity[static_cast<std::size_t>(network.column[static_cast<std::size_t>(k)])];
      smallest = std::min(smallest,
                          2 * c_i * c_j / ((c_i + c_j) * network.conductance[static_cast<std::size_t>(k)]));
    }
  return smallest;
}

FieldRange range_of(const Network& network, std::span<const double> free) {
  const auto [low, high] = std::minmax_element(free.begin(), free.end());
  FieldRange range{*low, *high};
  for (const auto& edge : network.ghost_edges) {
    const double value = network.ghost_value[static_cast<std::size_t>(edge.ghost)];
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  return range;
}

}  // namespace

ThermalBridge::ThermalBridge(std::string spec) : spec_(std::move(spec)) {
  (void)make_integrator(spec_);
}

Outcome ThermalBridge::advance(const MovingNetwork& moving, double h, std::span<double> temperature) {
  const double begin = process_cpu_seconds();
  const auto held = moving.held();
  for (std::size_t i = 0; i < temperature.size(); ++i)
    if (held[i] >= 0)
      temperature[i] = moving.model().thermal.wall_temperature[static_cast<std::size_t>(held[i])];
  Network network = moving.frozen_network();
  const std::size_t rows = network.size();
  free_.resize(rows);
  const std::vector<std::int32_t> node_of_row = network.node_of_row;
  for (std::size_t row = 0; row < rows; ++row)
    free_[row] = temperature[static_cast<std::size_t>(node_of_row[row])];
  const auto give_back = [&](std::span<const double> values) {
    for (std::size_t row = 0; row < rows; ++row)
      temperature[static_cast<std::size_t>(node_of_row[row])] = values[row];
  };
  if (network.nonzeros() == 0 && network.ghost_edges.empty()) {  // nothing conducts: exact
    for (std::size_t row = 0; row < rows; ++row)
      free_[row] += h * network.source[row] / network.capacity[row];
    give_back(free_);
    cpu_building_ += process_cpu_seconds() - begin;
    return {};
  }
  Plan plan;
  plan.output_times = {h};
  plan.ranges = {range_of(network, free_)};
  const double step = pair_step(network);
  NetworkRhs rhs(std::move(network), "temperature", "K", step);
  const double built = process_cpu_seconds();
  cpu_building_ += built - begin;

  const auto integrator = make_integrator(spec_);
  Outcome outcome;
  try {
    integrator->prepare(rhs, plan);
    integrator->start(0, free_);
    outcome = integrator->advance(h);
    if (outcome.ok()) give_back(integrator->state());
    const Statistics& statistics = integrator->statistics();
    steps_ += statistics.steps;
    rejected_ += statistics.rejected;
    max_stages_ = std::max(max_stages_, statistics.max_stages);
  } catch (const Refused& refused) {
    outcome = {Status::refused, refused.what()};
  } catch (const std::runtime_error& error) {  // of a factorization, say
    outcome = {Status::failed, error.what()};
  }
  sweeps_ += rhs.counters().sweeps;
  cpu_stepping_ += process_cpu_seconds() - built;
  if (!outcome.ok()) outcome.reason = spec_ + ": " + outcome.reason;
  return outcome;
}

}  // namespace superstep::dynamics
