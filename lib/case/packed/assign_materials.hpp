#pragma once
/// Materials by selection: `where` in a table of `[[materials]]`.

#include "core/text/toml.hpp"
#include "packing/packing.hpp"

namespace superstep {

/// Gives the particles that a material's `where` selects that material. Particles in no selection keep what
/// their file says; where it says nothing, every particle must be in one. Does nothing without `where`.
///   unit [m]  of lengths in selections
/// Throws InputError.
void assign_materials(TomlTable& root, double unit, Packing& packing);

}  // namespace superstep
