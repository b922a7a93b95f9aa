#pragma once
/// The linear system of a scene in files that any solver reads.

#include <string>
#include <vector>

#include "case/scene.hpp"

namespace superstep {

/// Writes each field's system C dX/dt = -K X + Y into the folder, in the Matrix Market's format: K.mtx (the
/// Laplacian of all nodes, those with fixed values included; surroundings are fixed nodes at its end),
/// capacity.mtx, source.mtx, initial.mtx, fixed.csv, nodes.csv (which row is which id), and case.toml, which
/// reads them back. A second field's files begin with its name. Conductivities that follow temperature are
/// written at their reference values, inputs that change in time at t = 0: comments say so, and what is
/// returned. Throws InputError for radiation, which is not linear, before anything is written.
[[nodiscard]] std::vector<std::string> write_system(const std::string& folder, const Scene& scene);

}  // namespace superstep
