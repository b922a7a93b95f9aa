#include "rhs/kernels/variable_conduction.hpp"

#include <algorithm>

#include "core/index.hpp"
#include "core/parallel.hpp"
#include "rhs/kernels/law_values.hpp"

namespace superstep {
namespace {

constexpr double margin_of_states = 0.01;

}  // namespace

SlotConductivity::SlotConductivity(ConductionLaws laws, std::vector<std::int32_t> node_of_slot)
    : laws_(std::move(laws)),
      node_of_slot_(std::move(node_of_slot)),
      value_(node_of_slot_.size()),
      slope_(node_of_slot_.size()) {
  // Before the first update: the reference values, for which the conductances were computed.
  for (std::size_t s = 0; s < value_.size(); ++s) value_[s] = law_of_slot(s).value;
  gathered_.resize(laws_.of_material.size() > 1 ? value_.size() : 0);
  slots_of_law_.resize(laws_.of_material.size() > 1 ? laws_.of_material.size() : 0);
  for (std::size_t s = 0; s < value_.size() && !slots_of_law_.empty(); ++s)
    slots_of_law_[at(laws_.material[at(node_of_slot_[s])])].push_back(static_cast<std::int32_t>(s));
  limited_ = std::any_of(laws_.of_material.begin(), laws_.of_material.end(),
                         [](const auto& law) { return law.limited(); });
}

void SlotConductivity::update(std::span<const double> temperature) {
  if (slots_of_law_.empty()) {
    for_ranges(value_.size(), value_.size(), [&](std::size_t first, std::size_t last) {
      law_values(laws_.of_material.front(), temperature.subspan(first, last - first),
                 std::span(value_).subspan(first, last - first));
    });
    return;
  }
  for (std::size_t law = 0; law < slots_of_law_.size(); ++law) {
    const auto& slots = slots_of_law_[law];
    const std::span<double> room = std::span(gathered_).first(slots.size());
    for_ranges(slots.size(), slots.size(), [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) room[k] = temperature[at(slots[k])];
      const auto part = room.subspan(first, last - first);
      law_values(laws_.of_material[law], part, part);
      for (std::size_t k = first; k < last; ++k) value_[at(slots[k])] = room[k];
    });
  }
}

void SlotConductivity::update_slopes(std::span<const double> temperature) {
  for (std::size_t s = 0; s < slope_.size(); ++s) slope_[s] = law_of_slot(s).slope(temperature[s]);
}

std::optional<std::size_t> SlotConductivity::first_outside(std::span<const double> temperature,
                                                           double slack) const noexcept {
  if (!limited_) return std::nullopt;
  for (std::size_t s = 0; s < temperature.size(); ++s) {
    const auto& law = law_of_slot(s);
    if (!law.limited() || law.covers(temperature[s], margin_of_states)) continue;
    if (!law.covers(temperature[s] - slack) && !law.covers(temperature[s] + slack)) return s;
  }
  return std::nullopt;
}

double SlotConductivity::largest_rise() const noexcept {
  double rise = 1;
  for (const auto& law : laws_.of_material) rise = std::max(rise, law.largest() / law.value);
  return rise;
}

VariableConduction::VariableConduction(const FieldOperator& field, const SlotConductivity& conductivity,
                                       std::span<const double> reference,
                                       std::span<const std::int32_t> slot_of_node) {
  const auto& network = field.network();
  for (const auto* nodes : {&network.node_of_row, &network.node_of_halo})
    for (const auto node : *nodes) slot_of_row_.push_back(slot_of_node[at(node)]);
  row_conductivity_.resize(slot_of_row_.size());
  conductance_.resize(network.nonzeros());
  geometry_.resize(network.nonzeros());
  with_mean(conductivity.mean(), [&](auto mean) {
    for (std::size_t i = 0; i < network.size(); ++i)
      for (auto k = network.row_begin[i]; k < network.row_begin[i + 1]; ++k)
        geometry_[at(k)] =
            network.conductance[at(k)] / mean.value(reference[at(slot_of_row_[i])],
                                                    reference[at(slot_of_row_[at(network.column[at(k)])])]);
    for (const auto& edge : network.ghost_edges) {
      const auto node = network.ghost_node[at(edge.ghost)];
      slot_of_ghost_edge_.push_back(node < 0 ? -1 : slot_of_node[at(node)]);
      ghost_geometry_.push_back(node < 0 ? edge.conductance
                                         : edge.conductance /
                                               mean.value(reference[at(slot_of_row_[at(edge.row)])],
                                                          reference[at(slot_of_ghost_edge_.back())]));
    }
  });
  ghost_conductance_ = ghost_geometry_;
  for (std::size_t e = 0; e < slot_of_ghost_edge_.size(); ++e)
    if (slot_of_ghost_edge_[e] >= 0) varying_ghost_edges_.push_back(static_cast<std::int32_t>(e));
  nodes_.resize(slot_of_row_.size());
  beyond_.resize(network.node_of_halo.size());
  scaled_geometry_ = SlicedRows(network.row_begin, network.column);
  const double factor = geometry_factor(conductivity.mean());
  scaled_geometry_.set_values(network.row_begin, [&](std::size_t row, std::size_t k) {
    return factor * geometry_[k] / network.capacity[row];
  });
}

/// Values of the columns beyond the own rows.
void VariableConduction::fetch_beyond(const FieldOperator& field, const double* y) {
  if (auto* halo = field.network().halo.get()) halo->fetch(y, beyond_.data());
}

void VariableConduction::update_ghosts(const SlotConductivity& conductivity, const FieldOperator& field) {
  const auto& network = field.network();
  const auto kappa = conductivity.value();
  with_mean(conductivity.mean(), [&](auto mean) {
    for (const auto e : varying_ghost_edges_)
      ghost_conductance_[at(e)] =
          ghost_geometry_[at(e)] * mean.value(kappa[at(slot_of_row_[at(network.ghost_edges[at(e)].row)])],
                                              kappa[at(slot_of_ghost_edge_[at(e)])]);
  });
}

void VariableConduction::stage(const SlotConductivity& conductivity, FieldOperator& field, double t,
                               const Stage& stage, double* out) {
  const auto kappa = conductivity.value();
  const auto mean = conductivity.mean();
  const std::size_t own = field.size();
  fetch_beyond(field, stage.y1);
  for_each_entry(nodes_.size(), [&](std::size_t i) {
    const double value = i < own ? stage.y1[i] : beyond_[i - own];
    nodes_[i] = {value, node_factor(mean, kappa[at(slot_of_row_[i])])};
  });
  update_ghosts(conductivity, field);
  field.set_ghost_conductances(varying_ghost_edges_, ghost_conductance_);
  field.varying_stage(t, mean, scaled_geometry_, nodes_.data(), stage, out);
}

void VariableConduction::apply(const SlotConductivity& conductivity, FieldOperator& field) {
  const auto& network = field.network();
  const auto kappa = conductivity.value();
  for (std::size_t i = 0; i < row_conductivity_.size(); ++i)
    row_conductivity_[i] = kappa[at(slot_of_row_[i])];
  with_mean(conductivity.mean(), [&](auto mean) {
    for (std::size_t i = 0; i < network.size(); ++i)
      for (auto k = network.row_begin[i]; k < network.row_begin[i + 1]; ++k)
        conductance_[at(k)] =
            geometry_[at(k)] * mean.value(row_conductivity_[i], row_conductivity_[at(network.column[at(k)])]);
  });
  update_ghosts(conductivity, field);
  field.set_conductances(conductance_, ghost_conductance_);
}

}  // namespace superstep
