#pragma once
/// The network while its particles move: contacts, forces, heat and current of one instant.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/contacts/contact_points.hpp"
#include "dynamics/current.hpp"
#include "dynamics/forces.hpp"
#include "dynamics/heat.hpp"
#include "dynamics/model.hpp"

namespace superstep::dynamics {

/// CPU time of the parts of a run [s].
struct PartTimes {
  double contacts = 0;  ///< neighbour list, geometry, bonds
  double forces = 0;
  double heat = 0;  ///< rates, or the thermal integrator
  double current = 0;
};

class MovingNetwork {
 public:
  /// Keeps references: both must outlive it.
  MovingNetwork(const Model& model, const Particles& particles);

  /// Contacts with particles and walls at these positions at a time t of `phase`, and what bonds do there.
  ///   temperature  [n] that bonds have and grow at
  ///   step         how far into the step this instant is
  void place(std::span<const Vec3> position, std::span<const double> temperature, const Phase& phase,
             double t, StepPart step = {});
  /// Sum of the forces at the instant last placed [N]; returns the normal force on the upper wall [N].
  ///   detail  whole: `explicit_limit` and `powers_of` may follow, of the same velocities and temperatures
  double forces(std::span<const Vec3> velocity, std::span<const double> temperature, std::span<Vec3> force,
                PairDetail detail = PairDetail::forces);
  /// Temperature rates at the instant last placed, with the current of the last `settle` [K/s].
  void rates(std::span<const double> temperature, std::span<double> rate);

  /// What happens once per accepted step, at the instant last placed: bonds form and break, particles that
  /// touch an electrified wall take its temperature, the current is solved anew.
  void settle(State& state, const Phase& phase);
  /// After `settle`, when temperatures were corrected: bonds, their rates and the heat of the currents
  /// follow.
  void refresh(State& state, const Phase& phase);
  /// The same from a stored state, whose bonds and currents stand.
  void resume(State& state, const Phase& phase);

  [[nodiscard]] const Model& model() const noexcept { return model_; }
  [[nodiscard]] const Particles& particles() const noexcept { return particles_; }
  [[nodiscard]] const ContactPoints& contacts() const noexcept { return contacts_; }
  [[nodiscard]] Placement placement() const noexcept {
    return {contacts_.points(), wall_contacts_, upper_wall_velocity_};
  }
  [[nodiscard]] std::span<const WallContact> walls() const noexcept { return wall_contacts_; }
  [[nodiscard]] double upper_wall_velocity() const noexcept { return upper_wall_velocity_; }  ///< m/s
  [[nodiscard]] const PairForces& pair_forces() const noexcept { return pair_forces_; }
  [[nodiscard]] Held held() const noexcept { return held_; }
  [[nodiscard]] const CurrentField& current() const noexcept { return current_; }
  [[nodiscard]] Network frozen_network() const;
  /// Longest stable explicit step [s] where the forces were last taken whole.
  [[nodiscard]] double explicit_limit(std::span<const double> temperature);
  /// Longest step [s] in which explicit temperatures stay between those around them, at the instant placed.
  [[nodiscard]] double heat_limit();
  /// Another number whenever what forces depend on, beside the velocities, may have changed.
  [[nodiscard]] std::uint64_t instant() const noexcept { return instant_; }

  PartTimes times;

 private:
  void touch_walls(State& state, const Phase& phase);
  void act_bonds(std::span<const double> temperature, StepPart step);

  const Model& model_;
  const Particles& particles_;
  ContactPoints contacts_;
  std::vector<WallContact> wall_contacts_;
  double upper_wall_velocity_ = 0;
  CurrentField current_;
  std::vector<std::int32_t> held_;
  std::vector<double> depth_, stiffness_, damping_, conductance_, mobility_;
  PairForces pair_forces_;
  std::uint64_t instant_ = 0;
};

}  // namespace superstep::dynamics
