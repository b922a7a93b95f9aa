#pragma once
/// Which columns are the position of a particle.

#include "packing/formats/columns/finder.hpp"

namespace superstep {

/// Fills in position, second_position and positions. Throws InputError where there is no position, or where
/// x, y and z have names of different kinds.
void find_positions(const ColumnFinder& finder, SphereColumns& columns);

}  // namespace superstep
