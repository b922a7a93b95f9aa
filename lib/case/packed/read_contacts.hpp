#pragma once
/// `[contact]` of a case: which particles touch, across gaps and by bonds too, and how wide their necks are.

#include <string>

#include "case/scene.hpp"
#include "core/text/toml.hpp"

namespace superstep {

/// Fills contacts and necks of a scene that has its packing. Reads `neck`, `file`, law parameters, `gap`,
/// `bond_radius` and `bonds`; lengths are in the packing's unit.
///   place   where the particles come from, for errors about them
/// Throws InputError.
void read_contacts(TomlTable& table, const std::string& place, PackingScene& scene);

}  // namespace superstep
