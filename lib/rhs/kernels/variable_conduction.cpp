#include "rhs/kernels/variable_conduction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/index.hpp"
#include "core/parallel.hpp"
#include "rhs/kernels/law_values.hpp"

namespace superstep {
namespace {

constexpr double margin_of_states = 0.01;

struct Range {
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
};

/// Temperatures that a law certainly covers.
Range inside(const ConductivityLaw& law) {
  if (!law.limited()) return {};
  if (law.kind == ConductivityLaw::Kind::table) return {law.temperatures.front(), law.temperatures.back()};
  constexpr double rounding = 1e-9;
  const double length = 1 / law.coefficient, zero = law.reference - length,
               reserve = rounding * (std::abs(law.reference) + std::abs(length));
  return law.coefficient > 0 ? Range{.from = zero + reserve} : Range{.to = zero - reserve};
}

/// Whether some value is outside; NaN is not.
bool any_outside(std::span<const double> values, const Range& range) noexcept {
  std::int64_t found = 0;  // as wide as what is compared
  for (const double value : values) found |= (value < range.from) | (value > range.to);
  return found != 0;
}

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
  for (const auto& law : laws_.of_material) {
    const Range range = inside(law);
    inside_from_ = std::max(inside_from_, range.from);
    inside_to_ = std::min(inside_to_, range.to);
  }
}

/// out[slot] of every slot by of_law(law, temperatures, results), for the slots of each law.
template <class OfLaw>
void SlotConductivity::evaluate(std::span<const double> temperature, std::span<double> out,
                                const OfLaw& of_law) {
  if (slots_of_law_.empty()) {
    for_ranges(out.size(), out.size(), [&](std::size_t first, std::size_t last) {
      of_law(laws_.of_material.front(), temperature.subspan(first, last - first),
             out.subspan(first, last - first));
    });
    return;
  }
  for (std::size_t law = 0; law < slots_of_law_.size(); ++law) {
    const auto& slots = slots_of_law_[law];
    const std::span<double> room = std::span(gathered_).first(slots.size());
    for_ranges(slots.size(), slots.size(), [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) room[k] = temperature[at(slots[k])];
      const auto part = room.subspan(first, last - first);
      of_law(laws_.of_material[law], part, part);
      for (std::size_t k = first; k < last; ++k) out[at(slots[k])] = room[k];
    });
  }
}

void SlotConductivity::update(std::span<const double> temperature) {
  evaluate(temperature, value_, law_values);
}

void SlotConductivity::update_slopes(std::span<const double> temperature) {
  evaluate(temperature, slope_, law_slopes);
}

std::optional<std::size_t> SlotConductivity::first_outside(std::span<const double> temperature,
                                                           double slack) const noexcept {
  if (!any_outside(temperature, {inside_from_, inside_to_})) return std::nullopt;
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
  rows_are_slots_ = true;
  for (std::size_t i = 0; i < network.size(); ++i)
    rows_are_slots_ = rows_are_slots_ && at(slot_of_row_[i]) == i;
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

/// Values y [rows] of the field side by side with the s of their conductivities.
void VariableConduction::pair_nodes(const SlotConductivity& conductivity, const FieldOperator& field,
                                    const double* y) {
  const double* kappa = conductivity.value().data();
  const auto mean = conductivity.mean();
  const std::size_t own = field.size();
  fetch_beyond(field, y);
  for_ranges(own, own, [&](std::size_t first, std::size_t last) {
    if (rows_are_slots_)
      for (std::size_t i = first; i < last; ++i) nodes_[i] = {y[i], node_factor(mean, kappa[i])};
    else
      for (std::size_t i = first; i < last; ++i)
        nodes_[i] = {y[i], node_factor(mean, kappa[at(slot_of_row_[i])])};
  });
  for_each_entry(beyond_.size(), [&](std::size_t k) {
    nodes_[own + k] = {beyond_[k], node_factor(mean, kappa[at(slot_of_row_[own + k])])};
  });
}

void VariableConduction::stage(const SlotConductivity& conductivity, FieldOperator& field, double t,
                               const Stage& stage, double* out) {
  pair_nodes(conductivity, field, stage.y1);
  update_ghosts(conductivity, field);
  field.set_ghost_conductances(varying_ghost_edges_, ghost_conductance_);
  field.varying_stage(t, conductivity.mean(), scaled_geometry_, nodes_.data(), stage, out);
}

void VariableConduction::row_sums(const SlotConductivity& conductivity, const FieldOperator& field,
                                  std::span<const double> ghost_value, std::span<const double> y,
                                  std::span<const char> varies, const JacobianSums& out) {
  const auto& network = field.network();
  const auto mean = conductivity.mean();
  const auto kappa = conductivity.value(), slope = conductivity.slope();
  pair_nodes(conductivity, field, y.data());
  bend_.resize(nodes_.size());
  for_each_entry(bend_.size(), [&](std::size_t i) {
    const auto slot = at(slot_of_row_[i]);
    bend_[i] = varies[slot] ? node_bend(mean, kappa[slot], slope[slot]) : 0;
  });
  varying_row_sums(mean, scaled_geometry_, nodes_.data(), bend_.data(), out);
  for_each_entry(network.size(), [&](std::size_t i) { out.conduction[i] *= 2; });  // and on the diagonal
  update_ghosts(conductivity, field);
  with_mean(mean, [&](auto mix) {
    for (std::size_t e = 0; e < network.ghost_edges.size(); ++e) {
      const auto& edge = network.ghost_edges[e];
      const auto row = at(edge.row);
      out.conduction[row] += ghost_conductance_[e] / network.capacity[row];
      if (slot_of_ghost_edge_[e] < 0) continue;
      const auto own = at(slot_of_row_[row]), other = at(slot_of_ghost_edge_[e]);
      const double factor =
          std::abs(ghost_geometry_[e] * (ghost_value[at(edge.ghost)] - y[row]) / network.capacity[row]);
      if (varies[own]) out.laws[row] += factor * std::abs(mix.slope(kappa[own], kappa[other]) * slope[own]);
      if (varies[other])
        out.laws[row] += factor * std::abs(mix.slope(kappa[other], kappa[own]) * slope[other]);
    }
  });
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
