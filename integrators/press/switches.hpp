#pragma once
/// Where, inside a step, bonds form or break and particles reach or leave an electrified wall: forces and
/// temperatures jump there, and a step that goes across it is of order 1.

#include <cstdint>
#include <utility>
#include <vector>

#include "dynamics/moving_network.hpp"

namespace superstep::dynamics {

/// What switches at the end of a step although it ends there only up to rounding.
struct Forced {
  std::vector<std::pair<std::int32_t, std::int32_t>> bonds;  ///< sorted
  std::vector<std::int32_t> particles;                       ///< held by a wall or let go, sorted
  [[nodiscard]] bool empty() const noexcept { return bonds.empty() && particles.empty(); }
};

/// One of them.
struct Switch {
  double part = 0;             ///< of the step, 0 to 1
  std::int32_t i = 0, j = -1;  ///< pair of a bond, or the particle i (j = -1)
};

/// Whether anything of this model jumps: its bonds, or the temperatures that electrified walls hold.
[[nodiscard]] bool has_switches(const Model& model) noexcept;

/// All switches between `begin` and the trial state of a step of h [s] at which the network is placed, by
/// cubic interpolation of the distances that decide: their error is of order h^4. Ascending in time.
[[nodiscard]] std::vector<Switch> find_switches(const MovingNetwork& network, const State& begin,
                                                const State& end, const Phase& phase, double h);

/// Those of them that belong to the first one: within `width` of the step.
[[nodiscard]] Forced together_with_first(const std::vector<Switch>& switches, double width);

}  // namespace superstep::dynamics
