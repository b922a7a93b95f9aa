#pragma once
/// Steady current through the particles, and the heat that it leaves behind.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dynamics/forces.hpp"
#include "dynamics/weighted_laplacian.hpp"

namespace superstep::dynamics {

/// Current [A] or potential [V] of the electrified walls; absent = the wall is not electrified.
struct Electrodes {
  std::optional<double> lower, upper;
  [[nodiscard]] bool any() const noexcept { return lower || upper; }
  [[nodiscard]] const std::optional<double>& of(Wall wall) const noexcept;
};

/// sigma of particle i at this temperature [K] and field [V/m] (Zohdi 2014, eq. 50) [S/m].
[[nodiscard]] inline double electric_conductivity(const ElectricLaw& law, const Particles& particles,
                                                  std::size_t i, double temperature, double field) noexcept {
  return value_of(particles.electric_conductivity, i, law.conductivity) *
         law.saturation.factor(temperature, field);
}
struct Branch {
  double conductance;  ///< mean conductivity times area over distance [S]
  double share;        ///< of its Joule heat that goes to particle i: R_i/(R_i + R_j), R ~ 1/sigma
};
/// Of a contact that potentials differ across by `drop` [V].
[[nodiscard]] Branch branch_of(const ElectricLaw& law, const Particles& particles,
                               const ContactPoint& contact, std::span<const double> temperature,
                               double drop) noexcept;

class CurrentField {
 public:
  /// Keeps a reference to the particles.
  CurrentField(const ElectricLaw& law, const Particles& particles);

  /// Whether these electrodes drive a current; nothing is looked at in a placement where they do not.
  [[nodiscard]] bool flows(const Electrodes& electrodes) const noexcept {
    return law_.model != CurrentModel::none && electrodes.any();
  }

  /// Solves for `electric` [n] (currents, or potentials) at these contacts and fills `heat()`. Throws
  /// NumericalError where no solution is found.
  void update(const Placement& placement, const Electrodes& electrodes, std::span<const double> temperature,
              std::span<double> electric);
  /// Fills `heat()` from values that are a solution at these contacts already: a solver that ran again could
  /// change their last digits.
  void restore(const Placement& placement, const Electrodes& electrodes, std::span<const double> temperature,
               std::span<double> electric);

  /// Joule heat of each particle [W].
  [[nodiscard]] std::span<const double> heat() const noexcept { return heat_; }
  /// Particles that a path of contacts joins to an electrified wall: whether each of them is, and how many.
  [[nodiscard]] std::span<const char> carrying() const noexcept { return carrying_; }
  [[nodiscard]] std::size_t connected() const noexcept { return connected_; }
  /// Systems of potentials solved so far.
  [[nodiscard]] std::uint64_t potential_solves() const noexcept { return potential_solves_; }
  /// The same at any placement, without solving for anything.
  [[nodiscard]] std::vector<char> reachable(const Placement& placement, const Electrodes& electrodes) const;

 private:
  enum class Values : char { solve, given };
  void evaluate(const Placement& placement, const Electrodes& electrodes, std::span<const double> temperature,
                std::span<double> electric, Values values);
  void averaging(const Placement& placement, const Electrodes& electrodes,
                 std::span<const double> temperature, std::span<double> electric, Values values);
  void potential(const Placement& placement, const Electrodes& electrodes,
                 std::span<const double> temperature, std::span<double> electric, Values values);
  void solve(std::span<double> x, Values values);

  void solve_in_turns(const Placement& placement, const Electrodes& electrodes, std::size_t n,
                      std::span<const double> temperature);
  void find_branches(const Placement& placement, const Electrodes& electrodes, std::size_t n,
                     std::span<const double> temperature);

  ElectricLaw law_;
  const Particles& particles_;
  std::vector<double> volume_;  // of each particle [m3]
  WeightedLaplacian laplacian_;
  std::vector<WeightedEdge> edges_;
  std::vector<double> share_;  // of the heat of each edge that its i gets
  std::vector<char> fixed_, carrying_;
  std::vector<double> depth_, values_, before_, change_before_, heat_;
  std::size_t connected_ = 0;
  std::uint64_t potential_solves_ = 0;
};

}  // namespace superstep::dynamics
