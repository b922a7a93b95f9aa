#pragma once
/// Particles and contacts of a scene that nobody has as a whole, for ParaView: each process writes a piece.

#include <cstddef>
#include <span>
#include <string>

#include "case/scene.hpp"

namespace superstep {

/// The arrays of VtkSeries for the nodes that are here and for the contacts whose first end is here. A second
/// end that is elsewhere is a point with `vtkGhostType` 1, of contacts alone. The root also writes the files
/// that hold the pieces together. Collective; the last two arguments are an instant [s] and the state of the
/// rows that are here. Throws EverybodysError.
void write_layered_frame(const Scene& scene, const std::string& folder, std::size_t frame, double t,
                         std::span<const double> state);

}  // namespace superstep
