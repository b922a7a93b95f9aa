#pragma once
/// `[packing]` and `[contact]` of a case: particles, contacts, necks.

#include <optional>
#include <string>

#include "case/scene.hpp"
#include "case/selection.hpp"
#include "core/text/toml.hpp"
#include "packing/generate.hpp"

namespace superstep {

/// Particles and contacts of a case with the unit of its lengths and the conductance law that it names.
struct PackingInput {
  PackingScene scene;
  double unit = 1;    ///< m per case length
  bool pipe = false;  ///< conductance law: pipe instead of series
  double t_end = 0;   ///< s; how far repeated profiles reach
  // Of a packing that is read part by part; else null.
  SelectionLog* selections = nullptr;  ///< whether they held anybody
  SelectionLog* fed = nullptr;         ///< whether what feeds particles feeds one that is free
};

struct SphereArrays;

/// Reads `[packing]` and `[contact]` from the root table. Files are looked up beside the case. Throws
/// InputError.
///   spheres  in memory, instead of a file or a generator; null = there are none
[[nodiscard]] PackingInput read_packing_scene(TomlTable& root, const SphereArrays* spheres = nullptr);

/// Reads `[contact]` for a scene that has its packing.
///   place  where the particles come from, for errors about them
void read_contact_table(TomlTable& root, const std::string& place, PackingInput& input);

/// A table of sizes: distribution = "lognormal", "uniform" or "list", with its numbers.
///   unit  m per length of the table
[[nodiscard]] SizeDistribution read_sizes(TomlTable table, double unit);

}  // namespace superstep
