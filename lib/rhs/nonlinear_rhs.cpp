#include "rhs/nonlinear_rhs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/index.hpp"
#include "core/parallel.hpp"
#include "network/cg_steady.hpp"
#include "rhs/network_rhs.hpp"

namespace superstep {
namespace {

bool linear(const NonlinearInput& input) {
  const bool laws = input.temperature.varies() || (input.potential && input.potential->varies());
  return !laws && !input.joule && !input.temperature.network.radiates();
}

bool autonomous(const NonlinearInput& input) {
  return input.temperature.network.inputs_are_constant() &&
         (!input.potential || input.potential->network.inputs_are_constant());
}

RhsTraits traits_of(const NonlinearInput& input) {
  const bool laws = input.temperature.varies() || (input.potential && input.potential->varies());
  const bool is_linear = linear(input);
  return {.linear = is_linear,
          .constant_jacobian = is_linear,
          .symmetric = !laws && !input.joule,
          .autonomous = autonomous(input),
          .smooth = input.temperature.smooth() && (!input.potential || input.potential->smooth()),
          .constant_blocks = !laws};
}

bool potential_in_state(const NonlinearInput& input) noexcept {
  return input.potential && !input.steady_potential;
}

FieldView view_of(const char* name, const char* unit, std::size_t offset, const Network& network) {
  return {.name = name,
          .unit = unit,
          .offset = offset,
          .count = network.size(),
          .origin = network.origin,
          .first_row = network.first_row(),
          .elsewhere = network.all_rows() - network.size()};
}

std::vector<FieldView> views_of(const NonlinearInput& input) {
  std::vector<FieldView> views;
  std::size_t offset = 0;
  if (potential_in_state(input)) {
    offset = input.potential->network.size();
    views.push_back(view_of("potential", "V", 0, input.potential->network));
  }
  views.push_back(view_of("temperature", "K", offset, input.temperature.network));
  return views;
}

std::size_t size_of(const NonlinearInput& input) {
  return input.temperature.network.size() + (potential_in_state(input) ? input.potential->network.size() : 0);
}

/// Slots: the temperature's rows first, then all other nodes in the graph's order.
std::vector<std::int32_t> number_slots(const Network& temperature) {
  std::vector<std::int32_t> slot_of_node = temperature.row_of_node;
  auto next = static_cast<std::int32_t>(temperature.size());
  for (auto& slot : slot_of_node)
    if (slot < 0) slot = next++;
  return slot_of_node;
}

NodeValues values_on_slots(const FieldInput& field, const std::vector<std::int32_t>& slot_of_node) {
  std::vector<std::int32_t> slot_of_row;
  for (const auto node : field.network.node_of_row) slot_of_row.push_back(slot_of_node[at(node)]);
  std::vector<KnownValue> known = field.known;
  for (auto& entry : known) entry.node = slot_of_node[at(entry.node)];
  NodeValues values(std::move(slot_of_row), std::move(known), field.network.tables);
  if (!field.node_halo) return values;
  std::vector<std::int32_t> slot_of_halo;
  for (const auto node : field.node_of_halo) slot_of_halo.push_back(slot_of_node[at(node)]);
  values.share(field.node_halo, std::move(slot_of_halo));
  return values;
}

SlotConductivity conductivity_on_slots(const FieldInput& field,
                                       const std::vector<std::int32_t>& slot_of_node) {
  std::vector<std::int32_t> node_of_slot(slot_of_node.size());
  for (std::size_t node = 0; node < slot_of_node.size(); ++node)
    node_of_slot[at(slot_of_node[node])] = static_cast<std::int32_t>(node);
  return {field.laws, std::move(node_of_slot)};
}

/// Conductivities that the conductances of the graph were computed with [slots].
std::vector<double> reference_conductivity(const FieldInput& field,
                                           const std::vector<std::int32_t>& slot_of_node) {
  std::vector<double> reference(slot_of_node.size());
  for (std::size_t node = 0; node < slot_of_node.size(); ++node)
    reference[at(slot_of_node[node])] = field.laws.of_node(static_cast<std::int32_t>(node)).value;
  return reference;
}

/// The place of each slot among those of the whole scene [slots]; empty where that is the slot itself.
std::vector<std::int64_t> order_of_slots(const NonlinearInput& input,
                                         const std::vector<std::int32_t>& slot_of_node) {
  std::vector<std::int64_t> order(input.order_of_node.size());
  for (std::size_t node = 0; node < order.size(); ++node)
    order[at(slot_of_node[node])] = input.order_of_node[node];
  return order;
}

template <class T>
const T* pointer_to(const std::optional<T>& value) noexcept {
  return value ? &*value : nullptr;
}

Stage shifted(const Stage& stage, std::size_t offset) noexcept {
  Stage out = stage;
  out.y1 += offset;
  if (out.y2) out.y2 += offset;
  if (out.y0) out.y0 += offset;
  if (out.f0) out.f0 += offset;
  return out;
}

}  // namespace

NonlinearRhs::NonlinearRhs(NonlinearInput input)
    : Rhs(size_of(input), traits_of(input), views_of(input), input.among()),
      temperature_offset_(potential_in_state(input) ? input.potential->network.size() : 0),
      slot_of_node_(number_slots(input.temperature.network)),
      id_(input.temperature.id),
      radiates_(input.temperature.network.radiates()) {
  if (potential_in_state(input)) capacity_ = input.potential->network.capacity;
  const auto& thermal_capacity = input.temperature.network.capacity;
  capacity_.insert(capacity_.end(), thermal_capacity.begin(), thermal_capacity.end());
  temperature_slots_.emplace(values_on_slots(input.temperature, slot_of_node_));
  if (input.temperature.varies())
    thermal_conductivity_.emplace(conductivity_on_slots(input.temperature, slot_of_node_));
  thermal_ = std::make_shared<FieldOperator>(input.temperature.network);
  if (thermal_conductivity_)
    thermal_law_.emplace(*thermal_, *thermal_conductivity_,
                         reference_conductivity(input.temperature, slot_of_node_), slot_of_node_);
  thermal_bound_ = spectral_bounds(thermal_->network()).smallest();
  joule_rate_.assign(thermal_->size(), 0.0);
  own_sum_.reserve(size());
  cross_sum_.reserve(size());
  if (thermal_conductivity_) law_sum_.reserve(thermal_->size());
  mark_slots(input);
  if (!input.potential) {
    find_facts(input);
    return;
  }

  const FieldInput& potential = *input.potential;
  const auto reference = reference_conductivity(potential, slot_of_node_);
  if (potential.varies()) electric_conductivity_.emplace(conductivity_on_slots(potential, slot_of_node_));
  if (input.joule) {
    joule_.emplace(*input.joule, slot_of_node_, thermal_->size(), thermal_->network().capacity, reference,
                   potential.laws.mean, order_of_slots(input, slot_of_node_));
  }
  auto values = values_on_slots(potential, slot_of_node_);
  if (input.steady_potential) {
    steady_ = std::make_unique<SteadyPotential>(potential.network, std::move(values));
    if (electric_conductivity_)
      steady_->vary(*electric_conductivity_, reference, slot_of_node_, input.resolve_change);
    mutable_counters().potential_solves += steady_->solves();
    find_facts(input);
    return;
  }
  potential_slots_.emplace(std::move(values));
  electric_ = std::make_shared<FieldOperator>(potential.network);
  if (electric_conductivity_)
    electric_law_.emplace(*electric_, *electric_conductivity_, reference, slot_of_node_);
  electric_bound_ = spectral_bounds(electric_->network()).smallest();
  networks_swept_ = 2;
  row_of_potential_slot_.assign(slot_of_node_.size(), -1);
  for (std::size_t row = 0; row < electric_->size(); ++row)
    row_of_potential_slot_[at(potential_slots_->slot_of_row(row))] = static_cast<std::int32_t>(row);
  driver_ =
      std::make_unique<NetworkRhs>(electric_, "potential", "V", potential.pair_step, mutable_counters());
  driven_ = std::make_unique<NetworkRhs>(thermal_, "temperature", "K", input.temperature.pair_step,
                                         mutable_counters());
  find_facts(input);
}

const FieldOperator& NonlinearRhs::field_operator(std::size_t field) const noexcept {
  return steps_potential() && field == 0 ? *electric_ : *thermal_;
}

void NonlinearRhs::update_conductivities(double t, const double* temperature, bool slopes) {
  if (!thermal_conductivity_ && !electric_conductivity_) return;
  const auto slots = temperature_slots_->on_slots(t, temperature);
  for (auto* conductivity : {&thermal_conductivity_, &electric_conductivity_}) {
    if (!*conductivity) continue;
    (*conductivity)->update(slots);
    if (slopes) (*conductivity)->update_slopes(slots);
  }
}

void NonlinearRhs::update_conductances(double t, const double* temperature, bool slopes) {
  update_conductivities(t, temperature, slopes);
  if (thermal_law_) thermal_law_->apply(*thermal_conductivity_, *thermal_);
  if (electric_law_) electric_law_->apply(*electric_conductivity_, *electric_);
}

std::span<const double> NonlinearRhs::potential_on_slots(double t, const double* y) {
  return steady_ ? steady_->on_slots(t, pointer_to(electric_conductivity_))
                 : potential_slots_->on_slots(t, y);
}

void NonlinearRhs::update_joule(double t, const double* y) {
  if (!joule_) return;
  const auto solves = steady_ ? steady_->solves() : 0;
  const auto potential = potential_on_slots(t, y);
  if (steady_) mutable_counters().potential_solves += steady_->solves() - solves;
  if (electric_conductivity_)
    joule_->rate(potential, *electric_conductivity_, joule_rate_);
  else
    joule_->rate(potential, joule_rate_);
}

void NonlinearRhs::do_stage(double t, const Stage& stage, std::span<double> out) {
  const auto potential_out = out.first(temperature_offset_);
  const auto temperature_out = out.subspan(temperature_offset_);
  const Stage of_temperature = shifted(stage, temperature_offset_);
  update_conductivities(t, of_temperature.y1);
  update_joule(t, stage.y1);
  if (electric_law_)
    electric_law_->stage(*electric_conductivity_, *electric_, t, stage, potential_out.data());
  else if (steps_potential())
    electric_->stage(t, stage, potential_out.data());
  if (thermal_law_)
    thermal_law_->stage(*thermal_conductivity_, *thermal_, t, of_temperature, temperature_out.data());
  else
    thermal_->stage(t, of_temperature, temperature_out.data());
  if (!joule_) return;
  for_each_entry(temperature_out.size(),
                 [&](std::size_t i) { temperature_out[i] += stage.d * joule_rate_[i]; });
}

void NonlinearRhs::do_linear_stage(const Stage& stage, std::span<double> out) {
  if (steps_potential()) electric_->conduction_stage(stage, out.data());
  thermal_->conduction_stage(shifted(stage, temperature_offset_), out.data() + temperature_offset_);
}

void NonlinearRhs::do_block_product(std::size_t field, std::span<const double> v, std::span<double> out) {
  field_operator(field).conduction_stage({.y1 = v.data(), .a = 0, .d = 1}, out.data());
}

double NonlinearRhs::inflow(double t, std::span<const double> y) {
  update_conductances(t, y.data() + temperature_offset_);
  update_joule(t, y.data());
  const double sum = thermal_->inflow(t, temperature_of(y));
  if (!joule_) return sum;
  const auto& capacity = thermal_->network().capacity;
  RowSum heat;
  for (std::size_t i = 0; i < joule_rate_.size(); ++i) heat.add(i, capacity[i] * joule_rate_[i]);
  return sum + reduction().sum(heat.exact());
}

double NonlinearRhs::linear_inflow(std::span<const double> v) const {
  return thermal_->conduction_inflow(temperature_of(v));
}

std::optional<std::string> NonlinearRhs::law_violation(std::span<const double> y, double slack) {
  const bool limited = radiates_ || (thermal_conductivity_ && thermal_conductivity_->limited()) ||
                       (electric_conductivity_ && electric_conductivity_->limited());
  if (!limited) return std::nullopt;
  const auto violation = violation_here(y, slack);
  return reduction().among() ? reduction().among()->first_of(violation) : violation;
}

std::optional<std::string> NonlinearRhs::violation_here(std::span<const double> y, double slack) const {
  const auto temperature = temperature_of(y);  // its rows are the first slots
  for (const auto* conductivity : {pointer_to(thermal_conductivity_), pointer_to(electric_conductivity_)}) {
    const auto slot = conductivity ? conductivity->first_outside(temperature, slack) : std::nullopt;
    if (!slot) continue;
    const auto node = conductivity->node_of_slot(*slot);
    const auto what =
        fmt::format("the temperature of node {} has reached", id_.empty() ? node : id_[at(node)]);
    return conductivity->law_of_slot(*slot).explain(what, temperature[*slot]);
  }
  return thermal_->radiation_violation(temperature, slack);
}

OneWayCoupling* NonlinearRhs::one_way() {
  return steps_potential() && !varies() ? this : nullptr;
}

Rhs& NonlinearRhs::driver() {
  return *driver_;
}

Rhs& NonlinearRhs::driven() {
  return *driven_;
}

void NonlinearRhs::rate(double t, std::span<const double> v, std::span<double> rate) {
  std::fill(rate.begin(), rate.end(), 0.0);
  if (joule_) joule_->rate(potential_slots_->on_slots(t, v.data()), rate);
}

void NonlinearRhs::drive(std::span<const double> rate) {
  static_cast<NetworkRhs&>(*driven_).drive(rate);
}

std::vector<double> NonlinearRhs::steady_driver(double residual) {
  if (!electric_->network().inputs_are_constant()) return {};
  return approximate_steady_state(electric_->network(), residual);
}

void NonlinearRhs::enter(double begin, double end) {
  thermal_->enter(begin, end);
  temperature_slots_->enter(begin, end);
  if (electric_) electric_->enter(begin, end);
  if (potential_slots_) potential_slots_->enter(begin, end);
  if (steady_) steady_->enter(begin, end);
}

void NonlinearRhs::leave() {
  thermal_->leave();
  temperature_slots_->leave();
  if (electric_) electric_->leave();
  if (potential_slots_) potential_slots_->leave();
  if (steady_) steady_->leave();
}

void NonlinearRhs::ask_accuracy(double relative) {
  if (steady_) steady_->ask_accuracy(relative);
}

std::span<const double> NonlinearRhs::steady_potential(double t, std::span<const double> temperature) {
  update_conductances(t, temperature.data());
  return steady_->on_rows(t, pointer_to(electric_conductivity_));
}

}  // namespace superstep
