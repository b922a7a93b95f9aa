#pragma once
/// [dynamics.particles]: who is in the press.

#include "case/press/read_model.hpp"
#include "core/text/toml.hpp"

namespace superstep::dynamics {

/// Either `count`, `radius`, `seed` for random sequential addition, or `list` of particles with a position
/// each. Generated particles are numbered as they were placed and stored bin by bin, for locality.
///   initial [K], density [kg/m3]
void read_particles(TomlTable table, double density, double initial, ModelInput& input);

}  // namespace superstep::dynamics
