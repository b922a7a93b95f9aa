#include "rhs/steady_potential.hpp"

#include <algorithm>
#include <cmath>

#include "core/index.hpp"

namespace superstep {

SteadyPotential::SteadyPotential(Network network, NodeValues values)
    : field_(std::move(network)),
      values_(std::move(values)),
      solver_(field_.network()),
      basis_(1 + field_.network().tables.size()),
      potential_(field_.size()) {
  solve_basis();
}

void SteadyPotential::vary(const SlotConductivity& conductivity, std::span<const double> reference,
                           std::span<const std::int32_t> slot_of_node, double resolve_change) {
  variable_.emplace(field_, conductivity, reference, slot_of_node);
  stated_change_ = resolve_change_ = resolve_change;
  solved_for_.assign(reference.begin(), reference.end());
}

void SteadyPotential::ask_accuracy(double relative) noexcept {
  resolve_change_ = relative > 0 ? std::min(relative, stated_change_) : stated_change_;
}

/// One solve for all constant inputs together, and one for each table at the value 1.
void SteadyPotential::solve_basis() {
  const auto& network = field_.network();
  for (std::size_t b = 0; b < basis_.size(); ++b) {
    const auto table = static_cast<std::int32_t>(b) - 1;
    std::vector<double> load = table < 0 ? network.source : std::vector<double>(network.size(), 0.0);
    for (const auto& edge : network.ghost_edges) {
      if (network.ghost_table[at(edge.ghost)] != table) continue;
      load[at(edge.row)] += edge.conductance * (table < 0 ? network.ghost_value[at(edge.ghost)] : 1.0);
    }
    for (const auto& source : network.tabled_sources)
      if (source.table == table) load[at(source.node)] += 1;
    basis_[b] = solver_.solve(load);
    ++solves_;
  }
  is_current_ = false;
}

bool SteadyPotential::moved(const SlotConductivity& conductivity) const noexcept {
  const auto now = conductivity.value();
  for (std::size_t s = 0; s < solved_for_.size(); ++s)
    if (!(std::abs(now[s] - solved_for_[s]) <= resolve_change_ * solved_for_[s])) return true;
  return false;
}

std::span<const double> SteadyPotential::on_rows(double t, const SlotConductivity* conductivity) {
  if (variable_ && moved(*conductivity)) {
    variable_->apply(*conductivity, field_);
    solver_.refactorize(field_.network());
    solve_basis();
    solved_for_.assign(conductivity->value().begin(), conductivity->value().end());
  }
  if (is_current_ && t == t_) return potential_;
  potential_ = basis_[0];
  for (std::size_t b = 1; b < basis_.size(); ++b) {
    const double value = field_.inputs().at(b - 1, t);
    for (std::size_t i = 0; i < potential_.size(); ++i) potential_[i] += value * basis_[b][i];
  }
  is_current_ = true;
  t_ = t;
  return potential_;
}

void SteadyPotential::enter(double begin, double end) noexcept {
  field_.enter(begin, end);
  values_.enter(begin, end);
  is_current_ = false;
}

void SteadyPotential::leave() noexcept {
  field_.leave();
  values_.leave();
  is_current_ = false;
}

std::span<const double> SteadyPotential::on_slots(double t, const SlotConductivity* conductivity) {
  return values_.on_slots(t, on_rows(t, conductivity).data());
}

}  // namespace superstep
