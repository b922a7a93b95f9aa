#pragma once
/// Layers of a table of particles, of which each process reads a part and gets the layers that it owns.

#include <memory>
#include <string>

#include "case/layers/layer_source.hpp"

namespace superstep {

/// Of `[packing] file = "..."` with order = "layers"; null for another packing, and for a file that cannot be
/// read in parts: then `why_not` says why. Throws InputError.
[[nodiscard]] std::unique_ptr<LayerSource> find_table_source(TomlTable& packing, std::string& why_not);

}  // namespace superstep
