#pragma once
/// Moving particles and their contacts at one instant, for ParaView.

#include "bench/output/vtk_poly_data.hpp"
#include "case/press/press.hpp"
#include "dynamics/moving_network.hpp"

namespace superstep {

/// Points with id, radius [m], temperature [K], velocity [m/s] and, when the case has a current, current [A]
/// or potential [V]. Keeps a reference to the positions of `state`.
[[nodiscard]] VtkPolyData sintering_particles(const Press& one, const dynamics::State& state);

/// Lines with overlap [m] (negative where only a bond holds a pair), area [m2], bonded (0 or 1),
/// conductance_temperature [W/K] and flux_temperature [W], positive from the first end to the second; the
/// same for `potential` [S, A] when the case computes potentials.
///   network  placed at `state`
[[nodiscard]] VtkPolyData sintering_contacts(const Press& one, const dynamics::MovingNetwork& network,
                                             const dynamics::State& state);

}  // namespace superstep
