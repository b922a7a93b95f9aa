#include "rhs/kernels/variable_conduction.hpp"

#include <algorithm>

#include "core/index.hpp"

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
  limited_ = std::any_of(laws_.of_material.begin(), laws_.of_material.end(),
                         [](const auto& law) { return law.limited(); });
}

void SlotConductivity::update(std::span<const double> temperature) {
  for (std::size_t s = 0; s < value_.size(); ++s) value_[s] = law_of_slot(s).at(temperature[s]);
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
  for (const auto node : network.node_of_row) slot_of_row_.push_back(slot_of_node[at(node)]);
  row_conductivity_.resize(network.size());
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
    for (std::size_t e = 0; e < network.ghost_edges.size(); ++e)
      if (slot_of_ghost_edge_[e] >= 0)
        ghost_conductance_[e] =
            ghost_geometry_[e] *
            mean.value(row_conductivity_[at(network.ghost_edges[e].row)], kappa[at(slot_of_ghost_edge_[e])]);
  });
  field.set_conductances(conductance_, ghost_conductance_);
}

}  // namespace superstep
