#include "dynamics/current.hpp"

#include <algorithm>
#include <numbers>

#include "core/index.hpp"

namespace superstep::dynamics {

const std::optional<double>& Electrodes::of(Wall wall) const noexcept {
  static const std::optional<double> none;
  return wall == superstep::dynamics::lower ? lower : wall == superstep::dynamics::upper ? upper : none;
}

CurrentField::CurrentField(const ElectricLaw& law, const Particles& particles)
    : law_(law), laplacian_(law.solver, law.tolerance), heat_(particles.size(), 0.0) {
  for (const double r : particles.radius) volume_.push_back(4.0 / 3.0 * std::numbers::pi * r * r * r);
}

void CurrentField::update(const Placement& placement, const Electrodes& electrodes,
                          std::span<double> electric) {
  evaluate(placement, electrodes, electric, Values::solve);
}

void CurrentField::restore(const Placement& placement, const Electrodes& electrodes,
                           std::span<double> electric) {
  evaluate(placement, electrodes, electric, Values::given);
}

void CurrentField::evaluate(const Placement& placement, const Electrodes& electrodes,
                            std::span<double> electric, Values values) {
  std::fill(heat_.begin(), heat_.end(), 0.0);
  connected_ = 0;
  if (law_.model == CurrentModel::none || !electrodes.any())
    std::fill(electric.begin(), electric.end(), 0.0);
  else if (law_.model == CurrentModel::averaging)
    averaging(placement, electrodes, electric, values);
  else
    potential(placement, electrodes, electric, values);
}

void CurrentField::solve(std::span<double> x, Values values) {
  if (values == Values::solve)
    laplacian_.solve(edges_, fixed_, x);
  else
    laplacian_.find_reached(edges_, fixed_);
}

// J_i = sum_j A_ij J_j / sum_j A_ij, and J of the wall where a particle touches an electrified one (of two,
// the one it is pressed into deeper). H_i = a J_i^2 V_i/sigma. Source: Zohdi (2014), eqs 35 and 42,
// section 5.2.
void CurrentField::averaging(const Placement& placement, const Electrodes& electrodes,
                             std::span<double> electric, Values values) {
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
  for (std::size_t i = 0; i < n; ++i) {
    connected_ += laplacian_.reached()[i] ? 1 : 0;
    heat_[i] = law_.absorption * electric[i] * electric[i] * volume_[i] / law_.conductivity;
  }
}

// Resistors sigma A/d between particles and to the walls, which are two nodes more. The heat of a branch goes
// to its two particles in equal parts (equal materials); that of a branch to a wall goes to its particle.
void CurrentField::potential(const Placement& placement, const Electrodes& electrodes,
                             std::span<double> electric, Values values) {
  const std::size_t n = electric.size();
  const auto node_of = [&](Wall wall) {
    return static_cast<std::int32_t>(wall == superstep::dynamics::lower ? n : n + 1);
  };
  values_.assign(electric.begin(), electric.end());
  values_.push_back(electrodes.lower.value_or(0.0));
  values_.push_back(electrodes.upper.value_or(0.0));
  fixed_.assign(n + 2, 0);
  fixed_[n] = electrodes.lower.has_value();
  fixed_[n + 1] = electrodes.upper.has_value();
  edges_.clear();
  for (const auto& contact : placement.contacts)
    if (contact.area > 0)
      edges_.push_back({contact.i, contact.j, law_.conductivity * contact.area / contact.distance});
  for (const auto& contact : placement.walls)
    if (electrodes.of(contact.wall) && contact.distance > 0)
      edges_.push_back(
          {contact.particle, node_of(contact.wall), law_.conductivity * contact.area / contact.distance});
  solve(values_, values);
  std::copy_n(values_.begin(), n, electric.begin());
  for (std::size_t i = 0; i < n; ++i) connected_ += laplacian_.reached()[i] ? 1 : 0;
  for (const auto& edge : edges_) {
    const std::size_t i = at(edge.i), j = at(edge.j);
    const double drop = values_[i] - values_[j];
    const double heat = law_.absorption * edge.weight * drop * drop;
    if (j >= n) {
      heat_[i] += heat;
    } else {
      heat_[i] += 0.5 * heat;
      heat_[j] += 0.5 * heat;
    }
  }
}

}  // namespace superstep::dynamics
