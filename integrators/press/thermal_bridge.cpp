#include "integrators/press/thermal_bridge.hpp"

#include <algorithm>
#include <utility>

#include "core/stopwatch.hpp"

namespace superstep::dynamics {
namespace {

/// Largest minus smallest temperature, those of walls that have an influence included [K]. Of this moment
/// alone, so that a run that goes on from a checkpoint does what it would have done.
double span_now(const Model& model, std::span<const double> temperature) {
  FieldRange range;
  for (const double value : temperature) range.take(value);
  if (model.thermal.walls_conduct || holds_temperatures(model))
    for (const double value : model.thermal.wall_temperature) range.take(value);
  return range.span();
}

}  // namespace

Outcome ThermalBridge::advance(const MovingNetwork& moving, double h, std::span<double> temperature,
                               const std::atomic<bool>* stop) {
  const double begin = process_cpu_seconds();
  const Model& model = moving.model();
  const double share = std::min(h / model.schedule.phases().back().end, 1.0);
  const auto held = moving.held();
  for (std::size_t i = 0; i < temperature.size(); ++i)
    if (held[i] >= 0) temperature[i] = model.thermal.wall_temperature[static_cast<std::size_t>(held[i])];
  Network network = moving.frozen_network();
  const std::vector<std::int32_t> node_of_row = network.node_of_row;
  free_.resize(node_of_row.size());
  for (std::size_t row = 0; row < free_.size(); ++row)
    free_[row] = temperature[static_cast<std::size_t>(node_of_row[row])];
  cpu_freezing_ += process_cpu_seconds() - begin;
  stretches_.take(std::move(network));
  stretches_.stop = stop;
  Outcome outcome = stretches_.advance(h, free_, span_now(model, temperature), share);
  if (!outcome.ok()) return outcome;
  for (std::size_t row = 0; row < free_.size(); ++row)
    temperature[static_cast<std::size_t>(node_of_row[row])] = free_[row];
  return outcome;
}

}  // namespace superstep::dynamics
