#include "dynamics/moving_network.hpp"

#include <algorithm>

#include "core/index.hpp"
#include "core/parallel.hpp"
#include "core/stopwatch.hpp"

namespace superstep::dynamics {
namespace {

class PartTimer {
 public:
  explicit PartTimer(double& total) : total_(total), begin_(process_cpu_seconds()) {}
  ~PartTimer() { total_ += process_cpu_seconds() - begin_; }
  PartTimer(const PartTimer&) = delete;
  PartTimer& operator=(const PartTimer&) = delete;

 private:
  double& total_;
  double begin_;
};

Electrodes electrodes_of(const Phase& phase) {
  return {phase.lower, phase.upper};
}

}  // namespace

MovingNetwork::MovingNetwork(const Model& model, const Particles& particles)
    : model_(model),
      particles_(particles),
      contacts_(model.bond, model.skin, particles, model.thermal.conductivity),
      current_(model.electric, particles),
      held_(particles.size(), -1),
      depth_(particles.size(), 0.0) {}

void MovingNetwork::place(std::span<const Vec3> position, std::span<const double> temperature,
                          const Phase& phase, double t, StepPart step) {
  const PartTimer timer(times.contacts);
  contacts_.place(position);
  act_bonds(temperature, step);
  find_wall_contacts(model_.box, phase.wall_height(t), position, particles_.radius, wall_contacts_);
  upper_wall_velocity_ = phase.wall_velocity();
  ++instant_;
}

void MovingNetwork::act_bonds(std::span<const double> temperature, StepPart step) {
  if (contacts_.bonds().empty()) return;
  const BondLaw& law = model_.bond;
  const bool grows = bond_kind(law.rule).grows && law.growth.activation > 0;
  mobility_.resize(grows ? particles_.size() : 0);
  for_each_entry(mobility_.size(),
                 [&](std::size_t i) { mobility_[i] = arrhenius_root(law.growth, temperature[i]); });
  contacts_.act({law, model_.contact, temperature, mobility_, step});
}

double MovingNetwork::forces(std::span<const Vec3> velocity, std::span<const double> temperature,
                             std::span<Vec3> force, PairDetail detail) {
  const PartTimer timer(times.forces);
  return sum_forces(model_, particles_, contacts_, wall_contacts_, upper_wall_velocity_, velocity,
                    temperature, detail, pair_forces_, force);
}

void MovingNetwork::rates(std::span<const double> temperature, std::span<double> rate) {
  const PartTimer timer(times.heat);
  heat_rates(model_.thermal, particles_, contacts_, wall_contacts_, held_, current_.heat(), temperature,
             rate);
}

void MovingNetwork::touch_walls(State& state, const Phase& phase) {
  std::fill(held_.begin(), held_.end(), -1);
  const Electrodes electrodes = electrodes_of(phase);
  if (!holds_temperatures(model_) || !electrodes.any()) return;
  std::fill(depth_.begin(), depth_.end(), 0.0);
  for (const auto& contact : wall_contacts_) {
    const auto i = static_cast<std::size_t>(contact.particle);
    if (!electrodes.of(contact.wall) || !(-contact.strain > depth_[i])) continue;
    depth_[i] = -contact.strain;
    held_[i] = contact.wall;
    ++instant_;
    state.temperature[i] = model_.thermal.wall_temperature[at(contact.wall)];
  }
}

void MovingNetwork::settle(State& state, const Phase& phase) {
  {
    const PartTimer timer(times.contacts);
    const bool bonded = !contacts_.bonds().empty();
    contacts_.update_bonds();
    state.bonds.assign(contacts_.bonds().begin(), contacts_.bonds().end());
    if (bonded || !state.bonds.empty()) ++instant_;
  }
  {
    const PartTimer timer(times.current);
    touch_walls(state, phase);
  }
  {
    const PartTimer timer(times.contacts);
    act_bonds(state.temperature, {});
    contacts_.begin_step();
  }
  const PartTimer timer(times.current);
  const Electrodes electrodes = electrodes_of(phase);
  // Contacts are listed for a current alone.
  current_.update(current_.flows(electrodes) ? placement() : Placement{}, electrodes, state.temperature,
                  state.electric);
}

void MovingNetwork::refresh(State& state, const Phase& phase) {
  ++instant_;
  act_bonds(state.temperature, {});
  contacts_.begin_step();
  current_.restore(placement(), electrodes_of(phase), state.temperature, state.electric);
}

void MovingNetwork::resume(State& state, const Phase& phase) {
  contacts_.set_bonds(state.bonds);
  place(state.position, state.temperature, phase, state.time);
  touch_walls(state, phase);
  refresh(state, phase);
}

Network MovingNetwork::frozen_network() const {
  return thermal_network(model_.thermal, particles_, placement(), held_, current_.heat());
}

double MovingNetwork::explicit_limit(std::span<const double> temperature) {
  const PartTimer timer(times.forces);
  return explicit_step_limit(model_, particles_, contacts_, pair_forces_, wall_contacts_, temperature,
                             stiffness_, damping_);
}

double MovingNetwork::heat_limit() {
  const PartTimer timer(times.heat);
  return heat_step_limit(model_.thermal, particles_, contacts_, wall_contacts_, held_, conductance_);
}

}  // namespace superstep::dynamics
