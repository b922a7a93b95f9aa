#pragma once
/// What `[packing]` says about its file.

#include "core/text/toml.hpp"
#include "packing/read_options.hpp"

namespace superstep {

/// Reads `length_unit`, `units`, `periodic`, `box`, `format`, `atom_style`, `columns` and `order`. Throws
/// InputError.
[[nodiscard]] PackingOptions read_packing_options(TomlTable& packing);

}  // namespace superstep
