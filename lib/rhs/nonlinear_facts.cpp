/// What is known about a coupled scene beforehand.

#include <algorithm>
#include <cmath>
#include <limits>

#include "rhs/nonlinear_rhs.hpp"

namespace superstep {
namespace {

/// Of all tables together at an instant: sum of magnitudes, from there on or just before.
double magnitude(const std::vector<TimeTable>& tables, double t, bool before) noexcept {
  double sum = 0;
  for (const auto& table : tables) sum += std::abs(before ? table.before(t) : table.at(t));
  return sum;
}

/// The last knot before t of any table; where there is none, some time before t.
double knot_before(const std::vector<TimeTable>& tables, double t) noexcept {
  double last = -std::numeric_limits<double>::infinity();
  for (const auto& table : tables)
    for (const double knot : table.time)
      if (knot < t) last = std::max(last, knot);
  return std::isfinite(last) ? last : t - 1 - std::abs(t);
}

double rms(const std::vector<double>& v) noexcept {
  double sum = 0;
  for (const double x : v) sum += x * x;
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, v.size())));
}

}  // namespace

bool FieldInput::smooth() const noexcept {
  return std::all_of(laws.of_material.begin(), laws.of_material.end(),
                     [](const auto& law) { return law.smooth(); });
}

bool FieldInput::varies() const noexcept {
  return std::any_of(laws.of_material.begin(), laws.of_material.end(),
                     [](const auto& law) { return law.varies(); });
}

void NonlinearRhs::find_facts(const NonlinearInput& input) {
  facts_.pair_step = input.temperature.pair_step;
  facts_.radiates = radiates_;
  FieldFacts thermal = thermal_->facts();
  if (joule_) {
    const auto& potential = *input.potential;
    const bool sourced_here = std::any_of(potential.network.source.begin(), potential.network.source.end(),
                                          [](double source) { return source != 0; }) ||
                              !potential.network.tabled_sources.empty();
    const bool sourced = reduction().any(sourced_here);
    thermal.has_sources = true;
    if (sourced) {
      thermal.source_rate = std::numeric_limits<double>::infinity();
    } else if (const double rate = reduction().largest(joule_->largest_rate(potential.high - potential.low));
               rate > 0) {  // a line may rise without end, and nothing times that is nothing
      thermal.source_rate += rate * (electric_conductivity_ ? electric_conductivity_->largest_rise() : 1);
    }
  }
  if (steps_potential()) {
    facts_.pair_step = std::min(facts_.pair_step, input.potential->pair_step);
    facts_.fields.push_back(electric_->facts());
    electric_->add_breakpoints(0, facts_.breakpoints);
  }
  facts_.fields.push_back(thermal);
  thermal_->add_breakpoints(facts_.fields.size() - 1, facts_.breakpoints);
  if (steady_ && joule_) add_steady_breakpoints();
  merge_breakpoints(facts_.breakpoints);
}

/// Joule heat is a square of what the tables say: where their sum v changes by dv, the heat q does by
/// 2 q dv/v at most, with q and v those of the strongest instant, which may end with a step.
void NonlinearRhs::add_steady_breakpoints() {
  const auto& tables = steady_->tables();
  double strongest = 0, largest = 0;
  bool before_step = false;
  for (const auto& table : tables)
    for (const double t : table.time)
      for (const bool before : {false, true})
        if (const double v = magnitude(tables, t, before); v > largest) {
          largest = v;
          strongest = t;
          before_step = before;
        }
  if (!(largest > 0)) return;
  std::vector<double> rate(thermal_->size());
  if (before_step) steady_->enter(knot_before(tables, strongest), strongest);
  joule_->rate(steady_->on_slots(strongest, electric_conductivity_ ? &*electric_conductivity_ : nullptr),
               rate);
  steady_->leave();
  const double weight = 2 * rms(rate) / largest;
  for (const auto& table : tables) add_knots(table, weight, 0, facts_.breakpoints);
}

}  // namespace superstep
