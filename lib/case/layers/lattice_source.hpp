#pragma once
/// Layers of a lattice, which everybody makes for himself.

#include <memory>

#include "case/layers/layer_source.hpp"

namespace superstep {

/// Of `[packing] generator = "lattice"` whose spheres touch their neighbours; null for another packing.
[[nodiscard]] std::unique_ptr<LayerSource> find_lattice_source(TomlTable& packing);

}  // namespace superstep
