#include "bench/measure/probe_set.hpp"

namespace superstep {
namespace {

/// Of a graph that holds the probed nodes alone.
std::vector<double> known_values(const FieldScene& field) {
  std::vector<double> values = field.graph.initial;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (field.graph.is_fixed[k]) values[k] = field.graph.fixed_value[k];
  return values;
}

}  // namespace

ProbeSet::ProbeSet(const Scene& scene) {
  if (scene.probes.empty()) return;
  for (std::size_t f = 0; f < scene.fields.size(); ++f) {
    const auto& field = scene.fields[f];
    if (field.steady && scene.moving_potential) continue;  // it is known at output times only
    const auto initial = scene.own_nodes ? known_values(field) : scene.values_on_nodes(f, 0.0, scene.initial);
    for (const auto& probe : scene.probes) {
      ProbeColumn column{.name = field.name + "_" + probe.label,
                         .field = field.name,
                         .initial = initial[static_cast<std::size_t>(probe.node)],
                         .origin = field.origin,
                         .graph = field.steady ? nullptr : &field.graph,
                         .node = static_cast<std::size_t>(probe.node)};
      if (const auto entry = scene.entry_of_node(f, probe.node); entry >= 0) {
        column.slot = static_cast<std::ptrdiff_t>(entries_.size());
        entries_.push_back(static_cast<std::size_t>(entry));
        initial_.push_back(scene.own_nodes ? column.initial - field.origin
                                           : scene.initial[static_cast<std::size_t>(entry)]);
      }
      columns_.push_back(std::move(column));
    }
  }
}

double ProbeColumn::known_at(double t) const noexcept {
  return graph && graph->is_fixed[node] ? graph->fixed_at(node, t) : initial;
}

const ProbeColumn* ProbeSet::first_in(const std::string& field) const noexcept {
  for (const auto& column : columns_)
    if (column.field == field && column.slot >= 0) return &column;
  return nullptr;
}

ProbeHistory ProbeSet::history() const {
  ProbeHistory history(entries_.size());
  history.append(0.0, initial_);
  return history;
}

}  // namespace superstep
