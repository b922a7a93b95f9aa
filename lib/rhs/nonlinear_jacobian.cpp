/// The Jacobian of a nonlinear right-hand side, and the bounds of its spectrum that follow from it.

#include <algorithm>
#include <cmath>

#include "core/index.hpp"
#include "rhs/nonlinear_rhs.hpp"

namespace superstep {
namespace {

/// Column of a row of the other field that another process has.
constexpr auto across_elsewhere = column_elsewhere - 1;

/// Passes on what stands in columns that are here.
template <class Add>
auto only_own(Add add) {
  return [add](std::size_t row, std::size_t column, double value) mutable {
    if (column < across_elsewhere) add(row, column, value);
  };
}

template <class T>
const T* pointer_to(const std::optional<T>& value) noexcept {
  return value ? &*value : nullptr;
}

}  // namespace

/// Which values on slots are unknowns, here or elsewhere.
void NonlinearRhs::mark_slots(const NonlinearInput& input) {
  const auto mark = [this](const std::vector<std::int32_t>& nodes, auto& moves) {
    for (const auto node : nodes) moves[at(slot_of_node_[at(node)])] = 1;
  };
  temperature_moves_.assign(slot_of_node_.size(), 0);
  potential_moves_.assign(slot_of_node_.size(), 0);
  mark(input.temperature.network.node_of_row, temperature_moves_);
  mark(input.temperature.node_of_halo, temperature_moves_);
  if (!input.potential || input.steady_potential) return;
  mark(input.potential->network.node_of_row, potential_moves_);
  mark(input.potential->node_of_halo, potential_moves_);
}

/// Passes on what a row owes to the temperature on a slot, if that may move.
template <class Add>
void NonlinearRhs::add_of_temperature(std::size_t row, std::size_t slot, double value, Add& add) const {
  if (slot < thermal_->size())
    add(row, temperature_offset_ + slot, value);
  else if (temperature_moves_[slot])
    add(row, row < temperature_offset_ ? across_elsewhere : column_elsewhere, value);
}

/// Every contribution to df/dy, the same ones in the same order at every state. The steady potential counts
/// as given: what it owes to the temperatures is left out, which costs Newton an iteration and no accuracy.
/// Columns of rows that other processes have are `column_elsewhere`, or `across_elsewhere` where the row is
/// of the other field.
template <class Add>
void NonlinearRhs::enumerate_jacobian(double t, std::span<const double> y, Add add) {
  update_conductances(t, y.data() + temperature_offset_, true);
  const auto add_temperature = [&](std::size_t row, std::size_t slot, double value) {
    add_of_temperature(row, slot, value, add);
  };
  if (steps_potential()) {
    electric_->jacobian(y, add);
    if (electric_law_)
      electric_law_->jacobian(*electric_conductivity_, *electric_, electric_->ghost_values(t), y,
                              add_temperature);
  }
  thermal_->jacobian(temperature_of(y), [&](std::size_t row, std::size_t column, double value) {
    add(temperature_offset_ + row, column == column_elsewhere ? column : temperature_offset_ + column, value);
  });
  if (thermal_law_)
    thermal_law_->jacobian(*thermal_conductivity_, *thermal_, thermal_->ghost_values(t), temperature_of(y),
                           [&](std::size_t row, std::size_t slot, double value) {
                             add_temperature(temperature_offset_ + row, slot, value);
                           });
  enumerate_joule(t, y, add);
}

/// The part of the Joule heat in it.
template <class Add>
void NonlinearRhs::enumerate_joule(double t, std::span<const double> y, Add& add) {
  if (!joule_) return;
  const auto add_potential = [&](std::size_t row, std::size_t slot, double value) {
    if (!steps_potential()) return;
    const auto entry = row_of_potential_slot_[slot];
    if (entry >= 0)
      add(temperature_offset_ + row, static_cast<std::size_t>(entry), value);
    else if (potential_moves_[slot] != 0)
      add(temperature_offset_ + row, across_elsewhere, value);
  };
  joule_->jacobian(potential_on_slots(t, y.data()), pointer_to(electric_conductivity_), add_potential,
                   [&](std::size_t row, std::size_t slot, double value) {
                     add_of_temperature(temperature_offset_ + row, slot, value, add);
                   });
}

SparsePattern NonlinearRhs::build_pattern() {
  const std::vector<double> state(size(), 1.0);
  return assembly_.build(size(), [&](auto add) { enumerate_jacobian(0, state, only_own(add)); });
}

void NonlinearRhs::do_jacobian(double t, std::span<const double> y, std::span<double> values) {
  (void)own_pattern();
  assembly_.fill(values, [&](auto add) { enumerate_jacobian(t, y, only_own(add)); });
}

double NonlinearRhs::spectral_bound(double t, std::span<const double> y) {
  if (varies()) return scaled_gershgorin(t, y);
  const double thermal = thermal_bound_ + radius_beyond_blocks(t, y);
  return steps_potential() ? std::max(thermal, electric_bound_) : thermal;
}

double NonlinearRhs::radius_beyond_blocks(double /*t*/, std::span<const double> y) const {
  return radiates_ ? thermal_->radiation_slope(temperature_of(y)) : 0;
}

/// Sums of |J| over the columns of a row's own field, in own_sum_, and over those of the other, in
/// cross_sum_. Where several contributions meet in one place, their magnitudes are added.
void NonlinearRhs::sum_rows_of_jacobian(double t, std::span<const double> y) {
  auto &own = own_sum_, &cross = cross_sum_;
  own.assign(size(), 0.0);
  cross.assign(size(), 0.0);
  const auto temperature = temperature_of(y);
  update_conductivities(t, temperature.data(), true);
  auto add = [&](std::size_t row, std::size_t column, double value) {
    const bool same =
        column == column_elsewhere ||
        (column != across_elsewhere && (row < temperature_offset_) == (column < temperature_offset_));
    (same ? own : cross)[row] += std::abs(value);
  };
  const auto potentials = std::span(own).first(temperature_offset_);
  const auto temperatures = std::span(own).subspan(temperature_offset_);
  auto of_temperature = [&](std::size_t row, std::size_t, double value) {
    temperatures[row] += std::abs(value);
  };
  if (electric_law_)
    electric_law_->row_sums(*electric_conductivity_, *electric_, electric_->ghost_values(t), y,
                            temperature_moves_, {potentials, std::span(cross).first(temperature_offset_)});
  else if (steps_potential())
    electric_->jacobian(y, add);
  if (thermal_law_) {
    law_sum_.resize(thermal_->size());
    thermal_law_->row_sums(*thermal_conductivity_, *thermal_, thermal_->ghost_values(t), temperature,
                           temperature_moves_, {temperatures, law_sum_});
    for (std::size_t i = 0; i < law_sum_.size(); ++i) temperatures[i] += law_sum_[i];
    thermal_->radiation_jacobian(temperature, of_temperature);
  } else {
    thermal_->jacobian(temperature, of_temperature);
  }
  if (joule_ && electric_conductivity_)
    joule_->add_row_sums(potential_on_slots(t, y.data()), *electric_conductivity_, temperature_moves_,
                         potential_moves_, {temperatures, std::span(cross).subspan(temperature_offset_)});
  else
    enumerate_joule(t, y, add);
}

/// Row sums of |J| after scaling the temperatures by theta bound its spectrum for every theta. With the
/// largest sums within the fields (a, c) and across (b, e), the theta with a + theta b = c + e/theta balances
/// the two fields. Its two products are all that is needed: up = theta b and down = e/theta are the roots of
/// up - down = c - a and up down = b e, each in the form without cancellation; theta itself overflows where a
/// cross term vanishes.
double NonlinearRhs::scaled_gershgorin(double t, std::span<const double> y) {
  sum_rows_of_jacobian(t, y);
  const auto &own = own_sum_, &cross = cross_sum_;
  double a = 0, b = 0, c = 0, e = 0;
  for (std::size_t i = 0; i < temperature_offset_; ++i) {
    a = std::max(a, own[i]);
    b = std::max(b, cross[i]);
  }
  for (std::size_t i = temperature_offset_; i < size(); ++i) {
    c = std::max(c, own[i]);
    e = std::max(e, cross[i]);
  }
  for (double* sum : {&a, &b, &c, &e}) *sum = reduction().largest(*sum);
  if (b == 0 || e == 0) return std::max(a, c);  // triangular: the cross terms do not reach the spectrum
  const double mean = std::sqrt(b) * std::sqrt(e), half = 0.5 * (c - a);  // sqrt(b e) could underflow
  const double larger = std::abs(half) + std::hypot(half, mean), smaller = mean * (mean / larger);
  const double up = half > 0 ? larger : smaller, down = half > 0 ? smaller : larger;
  double bound = 0;
  for (std::size_t i = 0; i < size(); ++i)
    bound = std::max(bound, own[i] + (i < temperature_offset_ ? up * (cross[i] / b) : down * (cross[i] / e)));
  return reduction().largest(bound);
}

}  // namespace superstep
