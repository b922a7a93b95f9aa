#pragma once
/// `probe` of a scene that is built in layers.

#include "case/layers/layered_scene.hpp"

namespace superstep {

/// Fills the scene's probes, and a graph that holds their nodes alone. Collective; layers that were brought
/// are there no longer. Throws InputError, on all processes the same.
void read_layer_probes(LayeredNodes& nodes, Scene& scene, Communicator& among);

}  // namespace superstep
