#pragma once
/// A press as a packing that other cases take up.

#include <string>
#include <vector>

#include "case/press/press.hpp"
#include "dynamics/moving_network.hpp"

namespace superstep {

/// Writes, by the ids of the particles,
///   FILE             centres, radii, materials, velocities, temperatures: `[packing] file` of a network,
///                    `[dynamics.particles] file` of another press
///   STEM.necks.csv   i,j,radius [m] of all contacts and necks, through which heat and current flow:
///                    `[contact] neck = "given"`
///   STEM.bonds.csv   i,j,overlap,growth: `[dynamics.particles] bonds`, where the case has bonds
/// with STEM = FILE without its ending. Returns the names of what was written. Without bonds, STEM.bonds.csv
/// of an earlier export is removed, with a note unless `quiet`.
std::vector<std::string> export_packing(const std::string& file, const Press& one,
                                        const dynamics::MovingNetwork& network, const dynamics::State& state,
                                        bool quiet);

}  // namespace superstep
