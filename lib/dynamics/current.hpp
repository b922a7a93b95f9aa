#pragma once
/// Steady current through the particles, and the heat that it leaves behind.

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

class CurrentField {
 public:
  CurrentField(const ElectricLaw& law, const Particles& particles);

  /// Solves for `electric` [n] (currents, or potentials) at these contacts and fills `heat()`.
  void update(const Placement& placement, const Electrodes& electrodes, std::span<double> electric);
  /// Fills `heat()` from values that are a solution at these contacts already: a solver that ran again could
  /// change their last digits.
  void restore(const Placement& placement, const Electrodes& electrodes, std::span<double> electric);

  /// Joule heat of each particle [W].
  [[nodiscard]] std::span<const double> heat() const noexcept { return heat_; }
  /// Particles that a path of contacts joins to an electrified wall.
  [[nodiscard]] std::size_t connected() const noexcept { return connected_; }

 private:
  enum class Values : char { solve, given };
  void evaluate(const Placement& placement, const Electrodes& electrodes, std::span<double> electric,
                Values values);
  void averaging(const Placement& placement, const Electrodes& electrodes, std::span<double> electric,
                 Values values);
  void potential(const Placement& placement, const Electrodes& electrodes, std::span<double> electric,
                 Values values);
  void solve(std::span<double> x, Values values);

  ElectricLaw law_;
  std::vector<double> volume_;  // of each particle [m3]
  WeightedLaplacian laplacian_;
  std::vector<WeightedEdge> edges_;
  std::vector<char> fixed_;
  std::vector<double> depth_, values_, heat_;
  std::size_t connected_ = 0;
};

}  // namespace superstep::dynamics
