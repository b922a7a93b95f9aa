#include "dynamics/current.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/index.hpp"

namespace superstep::dynamics {

const std::optional<double>& Electrodes::of(Wall wall) const noexcept {
  static const std::optional<double> none;
  return wall == superstep::dynamics::lower ? lower : wall == superstep::dynamics::upper ? upper : none;
}

Branch branch_of(const ElectricLaw& law, const Particles& particles, const ContactPoint& contact,
                 std::span<const double> temperature, double drop) noexcept {
  const double field = std::abs(drop) / contact.distance;
  const auto sigma = [&](std::int32_t i) {
    return electric_conductivity(law, particles, at(i), temperature[at(i)], field);
  };
  const double a = sigma(contact.i), b = sigma(contact.j);
  return {0.5 * (a + b) * contact.area / contact.distance, b / (a + b)};
}

CurrentField::CurrentField(const ElectricLaw& law, const Particles& particles)
    : law_(law),
      particles_(particles),
      laplacian_(law.solver, law.tolerance),
      carrying_(particles.size(), 0),
      heat_(particles.size(), 0.0) {
  for (const double r : particles.radius) volume_.push_back(4.0 / 3.0 * std::numbers::pi * r * r * r);
}

void CurrentField::update(const Placement& placement, const Electrodes& electrodes,
                          std::span<const double> temperature, std::span<double> electric) {
  evaluate(placement, electrodes, temperature, electric, Values::solve);
}

void CurrentField::restore(const Placement& placement, const Electrodes& electrodes,
                           std::span<const double> temperature, std::span<double> electric) {
  evaluate(placement, electrodes, temperature, electric, Values::given);
}

void CurrentField::evaluate(const Placement& placement, const Electrodes& electrodes,
                            std::span<const double> temperature, std::span<double> electric, Values values) {
  std::fill(heat_.begin(), heat_.end(), 0.0);
  std::fill(carrying_.begin(), carrying_.end(), 0);
  if (!flows(electrodes))
    std::fill(electric.begin(), electric.end(), 0.0);
  else if (law_.model == CurrentModel::averaging)
    averaging(placement, electrodes, temperature, electric, values);
  else
    potential(placement, electrodes, temperature, electric, values);
  connected_ = static_cast<std::size_t>(std::count(carrying_.begin(), carrying_.end(), 1));
}

std::vector<char> CurrentField::reachable(const Placement& placement, const Electrodes& electrodes) const {
  std::vector<char> fixed(particles_.size(), 0);
  for (const auto& contact : placement.walls)
    if (electrodes.of(contact.wall)) fixed[at(contact.particle)] = 1;
  std::vector<WeightedEdge> edges;
  for (const auto& contact : placement.contacts)
    if (contact.area > 0) edges.push_back({contact.i, contact.j, contact.area});
  WeightedLaplacian paths(law_.solver, law_.tolerance);
  paths.find_reached(edges, fixed);
  return {paths.reached().begin(), paths.reached().end()};
}

void CurrentField::solve(std::span<double> x, Values values) {
  if (values == Values::given) return laplacian_.find_reached(edges_, fixed_);
  laplacian_.solve(edges_, fixed_, x);
  if (law_.model == CurrentModel::potential) ++potential_solves_;
}

// J_i = sum_j A_ij J_j / sum_j A_ij, and J of the wall where a particle touches an electrified one (of two,
// the one it is pressed into deeper). H_i = a J_i^2 V_i/sigma. Source: Zohdi (2014), eqs 35 and 42,
// section 5.2.
void CurrentField::averaging(const Placement& placement, const Electrodes& electrodes,
                             std::span<const double> temperature, std::span<double> electric, Values values) {
  const std::size_t n = electric.size();
  fixed_.assign(n, 0);
  depth_.assign(n, 0.0);
  for (const auto& contact : placement.walls) {
    const auto& value = electrodes.of(contact.wall);
    const std::size_t i = at(contact.particle);
    if (!value || !(-contact.strain > depth_[i])) continue;
    fixed_[i] = 1;
    depth_[i] = -contact.strain;
    electric[i] = *value;
  }
  edges_.clear();
  for (const auto& contact : placement.contacts)
    if (contact.area > 0) edges_.push_back({contact.i, contact.j, contact.area});
  solve(electric, values);
  std::copy_n(laplacian_.reached().begin(), n, carrying_.begin());
  for (std::size_t i = 0; i < n; ++i)
    heat_[i] = law_.absorption * electric[i] * electric[i] * volume_[i] /
               electric_conductivity(law_, particles_, i, temperature[i], 0);
}

// Resistors sigma A/d between particles and to the walls, which are two nodes more. The heat of a branch goes
// to its two particles as their resistances, 1/sigma, are to each other: equal parts of equal ones. That of a
// branch to a wall goes to its particle.
void CurrentField::potential(const Placement& placement, const Electrodes& electrodes,
                             std::span<const double> temperature, std::span<double> electric, Values values) {
  const std::size_t n = electric.size();
  values_.assign(electric.begin(), electric.end());
  values_.push_back(electrodes.lower.value_or(0.0));
  values_.push_back(electrodes.upper.value_or(0.0));
  fixed_.assign(n + 2, 0);
  fixed_[n] = electrodes.lower.has_value();
  fixed_[n + 1] = electrodes.upper.has_value();
  if (law_.saturation.field != 0 && values == Values::solve) {
    solve_in_turns(placement, electrodes, n, temperature);
  } else {
    find_branches(placement, electrodes, n, temperature);
    solve(values_, values);
  }
  if (law_.saturation.field != 0) find_branches(placement, electrodes, n, temperature);
  std::copy_n(values_.begin(), n, electric.begin());
  std::copy_n(laplacian_.reached().begin(), n, carrying_.begin());
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    const WeightedEdge& edge = edges_[k];
    const std::size_t i = at(edge.i), j = at(edge.j);
    const double drop = values_[i] - values_[j];
    const double heat = law_.absorption * edge.weight * drop * drop;
    if (j >= n) {
      heat_[i] += heat;
    } else {
      heat_[i] += share_[k] * heat;
      heat_[j] += (1 - share_[k]) * heat;
    }
  }
}

/// Where the conductivity follows the field, conductances and potentials are found in turn until no potential
/// changes any more. Where a field below E_0 makes its branch a worse conductor, the turns swing about the
/// solution, and out to a cycle of two where the law is steep: a turn that swings and does not fall by half
/// takes half of the part of the change that the one before took; one that creeps takes more again.
void CurrentField::solve_in_turns(const Placement& placement, const Electrodes& electrodes, std::size_t n,
                                  std::span<const double> temperature) {
  constexpr int most_turns = 500;  // random networks of the steepest laws take some hundred
  constexpr double least = 1.0 / 4096;
  double part = 1, before = 0;
  change_before_.assign(values_.size(), 0.0);
  for (int turn = 0; turn < most_turns; ++turn) {
    before_ = values_;
    find_branches(placement, electrodes, n, temperature);
    solve(values_, Values::solve);
    double change = 0, largest = 0, swing = 0;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const double one = values_[i] - before_[i];
      change = std::max(change, std::abs(one));
      largest = std::max(largest, std::abs(values_[i]));
      swing += one * change_before_[i];
      change_before_[i] = one;
    }
    if (!(change > law_.tolerance * largest)) return;
    if (turn > 0 && change > 0.5 * before)
      part = swing < 0 ? std::max(part / 2, least) : std::min(part * 1.25, 1.0);
    before = change;
    if (part < 1)
      for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = before_[i] + part * change_before_[i];
  }
  throw NumericalError(fmt::format(
      "potentials and the conductivities that follow their field (saturation) still change by {:.1e} V after "
      "{} turns; take a smaller field_slope or field in [electric.saturation], or a larger tolerance",
      before, most_turns));
}

/// Conductances sigma A/d of all branches, at the field that the potentials at hand give.
void CurrentField::find_branches(const Placement& placement, const Electrodes& electrodes, std::size_t n,
                                 std::span<const double> temperature) {
  edges_.clear();
  share_.clear();
  const auto drop = [&](std::int32_t i, std::int32_t j) { return values_[at(i)] - values_[at(j)]; };
  for (const auto& contact : placement.contacts) {
    if (!(contact.area > 0)) continue;
    const Branch branch = branch_of(law_, particles_, contact, temperature, drop(contact.i, contact.j));
    edges_.push_back({contact.i, contact.j, branch.conductance});
    share_.push_back(branch.share);
  }
  for (const auto& contact : placement.walls) {
    if (!electrodes.of(contact.wall) || !(contact.distance > 0)) continue;
    const auto wall = static_cast<std::int32_t>(contact.wall == superstep::dynamics::lower ? n : n + 1);
    const double field = std::abs(drop(contact.particle, wall)) / contact.distance;
    const double sigma = electric_conductivity(law_, particles_, at(contact.particle),
                                               temperature[at(contact.particle)], field);
    edges_.push_back({contact.particle, wall, sigma * contact.area / contact.distance});
    share_.push_back(1);
  }
}

}  // namespace superstep::dynamics
