#include "rhs/network_rhs.hpp"

#include <algorithm>
#include <cmath>

namespace superstep {
namespace {

RhsTraits traits_of(const Network& network) {
  const bool linear = !network.radiates();
  return {.linear = linear,
          .constant_jacobian = linear,
          .symmetric = true,
          .autonomous = network.inputs_are_constant(),
          .constant_blocks = true};
}

FieldView view_of(const Network& network, std::string name, std::string unit) {
  return {.name = std::move(name),
          .unit = std::move(unit),
          .count = network.size(),
          .origin = network.origin,
          .first_row = network.first_row(),
          .elsewhere = network.all_rows() - network.size()};
}

}  // namespace

// Braces: the bound is found before the network moves on.
NetworkRhs::NetworkRhs(Network network, std::string field_name, std::string unit, double pair_step,
                       bool keep_network)
    : NetworkRhs{spectral_bounds(network).smallest(),
                 std::move(network),
                 std::move(field_name),
                 std::move(unit),
                 pair_step,
                 keep_network} {}

NetworkRhs::NetworkRhs(double bound, Network network, std::string field_name, std::string unit,
                       double pair_step, bool keep_network)
    : Rhs(network.size(), traits_of(network), {view_of(network, std::move(field_name), std::move(unit))},
          network.among()),
      field_(std::make_shared<FieldOperator>(std::move(network), keep_network)),
      bound_(bound) {
  find_facts(pair_step);
}

NetworkRhs::NetworkRhs(std::shared_ptr<FieldOperator> field, std::string field_name, std::string unit,
                       double pair_step, RhsCounters& counters)
    : Rhs(field->size(), traits_of(field->network()),
          {view_of(field->network(), std::move(field_name), std::move(unit))}, field->network().among()),
      field_(std::move(field)),
      bound_(spectral_bounds(field_->network()).smallest()) {
  count_into(counters);
  find_facts(pair_step);
}

void NetworkRhs::find_facts(double pair_step) {
  facts_.pair_step = pair_step;
  facts_.radiates = network().radiates();
  facts_.fields = {field_->facts()};
  field_->add_breakpoints(0, facts_.breakpoints);
  merge_breakpoints(facts_.breakpoints);
}

void NetworkRhs::do_stage(double t, const Stage& stage, std::span<double> out) {
  field_->stage(t, stage, out.data());
  for_each_entry(drive_.size(), [&](std::size_t i) { out[i] += stage.d * drive_[i]; });
}

void NetworkRhs::do_chain(std::span<ChainedStage> stages, bool with_inflow, ChainObserver* observer) {
  field_->chain(stages, with_inflow, drive_, observer);
  if (!driven_ || !with_inflow) return;
  const double driven = drive_inflow();
  for (auto& stage : stages) stage.inflow += driven;
}

void NetworkRhs::drive(std::span<const double> rate) {
  drive_ = rate;
  driven_ = reduction().any(!rate.empty());
  FieldFacts& facts = facts_.fields.front();  // rates are sources, and methods size their work by them
  facts = field_->facts();
  for (const double r : rate) facts.source_rate = std::max(facts.source_rate, std::abs(r));
  facts.source_rate = reduction().largest(facts.source_rate);
  facts.has_sources = facts.source_rate > 0;
}

double NetworkRhs::drive_inflow() const {
  return reduction().sum([&](std::size_t i) { return network().capacity[i] * drive_[i]; });
}

double NetworkRhs::inflow(double t, std::span<const double> y) {
  const double own = field_->inflow(t, y);
  return driven_ ? own + drive_inflow() : own;
}

void NetworkRhs::do_linear_stage(const Stage& stage, std::span<double> out) {
  field_->conduction_stage(stage, out.data());
}

void NetworkRhs::do_block_product(std::size_t /*field*/, std::span<const double> v, std::span<double> out) {
  field_->conduction_stage({.y1 = v.data(), .a = 0, .d = 1}, out.data());
}

SparsePattern NetworkRhs::build_pattern() {
  return assembly_.build(size(),
                         [&](auto add) { field_->jacobian(field_->network().source, only_here(add)); });
}

void NetworkRhs::do_jacobian(double /*t*/, std::span<const double> y, std::span<double> values) {
  (void)own_pattern();
  assembly_.fill(values, [&](auto add) { field_->jacobian(y, only_here(add)); });
}

double NetworkRhs::spectral_bound(double t, std::span<const double> y) {
  return bound_ + radius_beyond_blocks(t, y);
}

std::optional<std::string> NetworkRhs::law_violation(std::span<const double> y, double slack) {
  if (!facts_.radiates) return std::nullopt;
  const auto violation = field_->radiation_violation(y, slack);
  return reduction().among() ? reduction().among()->first_of(violation) : violation;
}

double NetworkRhs::radius_beyond_blocks(double /*t*/, std::span<const double> y) const {
  return field_->radiation_slope(y);
}

}  // namespace superstep
