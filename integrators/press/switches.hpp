#pragma once
/// Where, inside a step, bonds form or break, particles reach or leave an electrified wall, and paths of the
/// current close or open: forces, temperatures or heat jump there, and a step that goes across is of order 1.

#include <cstdint>
#include <vector>

#include "dynamics/moving_network.hpp"

namespace superstep::dynamics {

/// One of them.
struct Switch {
  double part = 0;             ///< of the step, 0 to 1
  std::int32_t i = 0, j = -1;  ///< the pair, or the particle i at a wall (j = -1)
};

/// Whether anything of this model jumps.
[[nodiscard]] bool has_switches(const Model& model) noexcept;

/// All switches between `begin`, where the network was settled, and the trial state of a step of h [s] at
/// which it is placed, by cubic interpolation of the distances that decide: their error is of order h^4.
/// Ascending in time.
[[nodiscard]] std::vector<Switch> find_switches(const MovingNetwork& network, const State& begin,
                                                const State& end, const Phase& phase, double h);

}  // namespace superstep::dynamics
