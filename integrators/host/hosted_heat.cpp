#include "integrators/host/hosted_heat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/inputs/workable_times.hpp"
#include "core/error.hpp"
#include "core/index.hpp"
#include "network/graph.hpp"
#include "network/network_in_order.hpp"

namespace superstep {
namespace {

/// As in a case: beyond, squares of what solvers form leave the range of a double.
constexpr double largest = largest_number, smallest = 1 / largest_number;

void require_values(const char* what, std::span<const double> values, std::size_t particles, bool positive) {
  if (values.size() != particles)
    throw InputError(
        fmt::format("HostedHeat: {} {} for {} particles; give one for each", values.size(), what, particles));
  const double least = positive ? smallest : -largest;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!(values[k] >= least && values[k] <= largest))
      throw InputError(fmt::format("HostedHeat: value {} of {} is {}; it must lie between {:g} and {:g}", k,
                                   what, values[k], least, largest));
}

bool same_pair(const HostedHeat::Contact& a, const HostedHeat::Contact& b) noexcept {
  return a.i == b.i && a.j == b.j;
}

bool same(const HostedHeat::Contact& a, const HostedHeat::Contact& b) noexcept {
  return same_pair(a, b) && a.conductance == b.conductance;
}

}  // namespace

HostedHeat::HostedHeat(std::span<const double> capacities, std::span<const double> temperatures,
                       std::string method)
    : stretches_(std::move(method)) {
  set_particles(capacities, temperatures);
}

void HostedHeat::set_particles(std::span<const double> capacities, std::span<const double> temperatures) {
  require_values("capacities", capacities, temperatures.size(), true);
  require_values("temperatures", temperatures, capacities.size(), false);
  capacity_.assign(capacities.begin(), capacities.end());
  temperature_.assign(temperatures.begin(), temperatures.end());
  source_.assign(capacity_.size(), 0.0);
  held_.assign(capacity_.size(), 0);
  contacts_.clear();
  order_.clear();
  spoil(Stale::structure);
}

void HostedHeat::set_contacts(std::span<const Contact> contacts) {
  const auto n = static_cast<std::int64_t>(capacity_.size());
  std::size_t conducting = 0;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto& [i, j, conductance] = contacts[k];
    if (i < 0 || j < 0 || i >= n || j >= n || i == j)
      throw InputError(fmt::format("HostedHeat: contact {} joins {} and {}; it must join two of {} particles",
                                   k, i, j, n));
    if (conductance != 0 && !(conductance >= smallest && conductance <= largest))
      throw InputError(fmt::format(
          "HostedHeat: contact {} ({}-{}) has conductance {}; it must be 0, or lie between {:g} and "
          "{:g} [W/K]",
          k, i, j, conductance, smallest, largest));
    if (conductance > 0) ++conducting;
  }
  bool same_places = conducting == contacts_.size(), same_values = true;
  std::size_t kept = 0;
  for (const auto& contact : contacts) {
    if (contact.conductance == 0 || !same_places) continue;
    same_places = same_pair(contact, contacts_[kept]);
    same_values = same_values && same(contact, contacts_[kept]);
    ++kept;
  }
  if (same_places && same_values) return;
  spoil(same_places ? Stale::values : Stale::structure);
  contacts_.clear();
  for (const auto& contact : contacts)
    if (contact.conductance > 0) contacts_.push_back(contact);
}

void HostedHeat::set_capacities(std::span<const double> capacities) {
  require_values("capacities", capacities, capacity_.size(), true);
  if (std::ranges::equal(capacities, capacity_)) return;
  capacity_.assign(capacities.begin(), capacities.end());
  spoil(Stale::values);
}

void HostedHeat::set_temperatures(std::span<const double> temperatures) {
  require_values("temperatures", temperatures, temperature_.size(), false);
  for (std::size_t k = 0; k < temperatures.size(); ++k) {
    if (is_held(k) && temperatures[k] != temperature_[k]) spoil(Stale::values);
    temperature_[k] = temperatures[k];
  }
}

void HostedHeat::set_sources(std::span<const double> sources) {
  require_values("sources", sources, source_.size(), false);
  if (std::ranges::equal(sources, source_)) return;
  source_.assign(sources.begin(), sources.end());
  spoil(Stale::values);
}

void HostedHeat::require(std::size_t particle) const {
  if (particle >= capacity_.size())
    throw InputError(fmt::format("HostedHeat: there is no particle {}; there are {}, counted from 0",
                                 particle, capacity_.size()));
}

void HostedHeat::hold(std::size_t particle, double temperature) {
  require(particle);
  if (!(std::abs(temperature) <= largest))
    throw InputError(
        fmt::format("HostedHeat: particle {} is to be held at {}; it must not exceed {:g} in size", particle,
                    temperature, largest));
  if (!is_held(particle)) {
    order_.clear();
    spoil(Stale::structure);
  } else if (temperature_[particle] != temperature) {
    spoil(Stale::values);
  }
  held_[particle] = 1;
  temperature_[particle] = temperature;
}

void HostedHeat::release(std::size_t particle) {
  require(particle);
  if (is_held(particle)) {
    order_.clear();
    spoil(Stale::structure);
  }
  held_[particle] = 0;
}

void HostedHeat::set_span(double span) {
  if (!(std::isfinite(span) && span > 0))
    throw InputError(fmt::format("HostedHeat: the span is {}; it must be finite and > 0 [K]", span));
  stated_span_ = span;
}

Network HostedHeat::new_network() const {
  Graph graph = equal_nodes(capacity_.size());
  std::vector<NodeRole> roles(capacity_.size(), NodeRole::free);
  graph.capacity = capacity_;
  graph.source = source_;
  for (std::size_t k = 0; k < held_.size(); ++k) {
    if (!is_held(k)) continue;
    roles[k] = NodeRole::fixed;
    graph.is_fixed[k] = 1;
    graph.fixed_value[k] = temperature_[k];
  }
  for (const auto& contact : contacts_) {
    graph.i.push_back(contact.i);
    graph.j.push_back(contact.j);
    graph.conductance.push_back(contact.conductance);
  }
  // As for a case: digits that all temperatures share would be lost in every difference.
  const auto [low, high] = std::ranges::minmax(temperature_);
  const double origin = low > 0 ? low : std::min(high, 0.0);
  return order_.empty() ? build_network(graph, roles, origin)
                        : build_network_in_order(graph, roles, origin, order_);
}

void HostedHeat::build() {
  // Neighbours stay neighbours for a while; then looking for another order costs little beside what was
  // spared.
  constexpr int most_networks = 50;
  if (orders_used_ == most_networks) order_.clear();
  if (order_.empty()) orders_used_ = 0;
  network_ = new_network();
  order_ = network_.node_of_row;
  ++orders_used_;
  find_places();
}

void HostedHeat::find_places() {
  const auto& row_of = network_.row_of_node;
  const auto entry = [&](std::int32_t row, std::int32_t column) {
    const auto begin = network_.column.begin() + network_.row_begin[at(row)];
    const auto end = network_.column.begin() + network_.row_begin[at(row) + 1];
    return std::lower_bound(begin, end, column) - network_.column.begin();
  };
  place_.assign(contacts_.size(), {-1, -1});
  std::vector<std::pair<std::int32_t, std::size_t>> to_ghosts;  // row and contact
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const auto a = row_of[at(contacts_[k].i)], b = row_of[at(contacts_[k].j)];
    if (a >= 0 && b >= 0)
      place_[k] = {entry(a, b), entry(b, a)};
    else if (a >= 0 || b >= 0)
      to_ghosts.emplace_back(std::max(a, b), k);
  }
  std::ranges::sort(to_ghosts);  // as the network has them: by row, then in the order of the contacts
  for (std::size_t edge = 0; edge < to_ghosts.size(); ++edge)
    place_[to_ghosts[edge].second].first = static_cast<std::int64_t>(edge);
}

/// New values in the old places.
void HostedHeat::fill() {
  const auto& row_of = network_.row_of_node;
  std::ranges::fill(network_.conductance, 0.0);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const auto [first, second] = place_[k];
    if (second >= 0) {
      network_.conductance[at(first)] += contacts_[k].conductance;
      network_.conductance[at(second)] += contacts_[k].conductance;
    } else if (first >= 0) {
      network_.ghost_edges[at(first)].conductance = contacts_[k].conductance;
    }
  }
  for (std::size_t ghost = 0; ghost < network_.ghost_value.size(); ++ghost)
    network_.ghost_value[ghost] = temperature_[at(network_.ghost_node[ghost])] - network_.origin;
  for (std::size_t k = 0; k < capacity_.size(); ++k) {
    if (row_of[k] < 0) continue;
    network_.capacity[at(row_of[k])] = capacity_[k];
    network_.source[at(row_of[k])] = source_[k];
  }
}

void HostedHeat::gather() {
  row_value_.resize(network_.size());
  for (std::size_t row = 0; row < row_value_.size(); ++row)
    row_value_[row] = temperature_[at(network_.node_of_row[row])] - network_.origin;
}

/// Part of the tolerance that a call may use up. Nobody says how many there will be: with a = ln(t/t_1), t
/// the time since the start and t_1 that of the first call, dt/(2 t (1 + a)^2) adds up to at most 1, since
/// the integral of 1/(1 + a)^2 over all a > 0 is 1. Taken down to a power of 16, so that a method stays
/// prepared for many calls.
double HostedHeat::share(double dt) const noexcept {
  const double time = elapsed_ + dt, age = 1 + std::log(time / (first_ > 0 ? first_ : dt));
  const double part = 0.5 * dt / (time * age * age);
  constexpr int bits = 4, usual = -2 * bits;  // of the first calls
  return std::ldexp(1.0, std::min(usual, bits * static_cast<int>(std::floor(std::log2(part) / bits))));
}

Outcome HostedHeat::advance_temperatures(double dt) {
  if (const auto rule = unworkable_time("dt =", dt); !rule.empty()) throw InputError("HostedHeat: " + rule);
  if (temperature_.empty()) return {};
  if (stale_ == Stale::structure) build();
  if (stale_ == Stale::values) fill();
  if (stale_ != Stale::nothing) stretches_.take(network_);
  stale_ = Stale::nothing;
  for (const double temperature : temperature_) seen_.take(temperature);
  gather();
  Outcome outcome =
      stretches_.advance(dt, row_value_, stated_span_ > 0 ? stated_span_ : seen_.span(), share(dt));
  if (!outcome.ok()) return outcome;
  elapsed_ += dt;
  if (first_ == 0) first_ = dt;
  for (std::size_t row = 0; row < row_value_.size(); ++row) {
    double& temperature = temperature_[at(network_.node_of_row[row])];
    if (row_value_[row] != temperature - network_.origin)  // else not even a rounding
      temperature = row_value_[row] + network_.origin;
  }
  return outcome;
}

double HostedHeat::heat() const {
  double sum = 0;
  for (std::size_t k = 0; k < capacity_.size(); ++k) sum += capacity_[k] * temperature_[k];
  return sum;
}

}  // namespace superstep
