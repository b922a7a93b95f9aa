#pragma once
/// A press as a packing that other cases take up.

#include <string>
#include <vector>

#include "case/press/press.hpp"
#include "dynamics/moving_network.hpp"

namespace superstep {

/// Writes FILE (the packing: `[packing] file`), and beside it, with the stem of FILE,
///   .necks.csv  i,j,radius [m] of contacts and necks, through which heat and current flow (`[contact] neck =
///   "given"`) .state.csv  id,vx,vy,vz,temperature (`[dynamics.particles] state`) .bonds.csv
///   i,j,overlap,growth (`[dynamics.particles] bonds`), where the case has bonds
/// by their ids. Returns the names of what was written.
std::vector<std::string> export_packing(const std::string& file, const Press& one,
                                        const dynamics::MovingNetwork& network, const dynamics::State& state);

}  // namespace superstep
