#pragma once
/// `[packing]` and `[contact]` of a case: particles, contacts, necks.

#include <optional>
#include <string>

#include "case/scene.hpp"
#include "core/text/toml.hpp"
#include "packing/generate.hpp"

namespace superstep {

/// Particles and contacts of a case with the unit of its lengths and the conductance law that it names.
struct PackingInput {
  PackingScene scene;
  double unit = 1;    ///< m per case length
  bool pipe = false;  ///< conductance law: pipe instead of series
};

/// Reads `[packing]` and `[contact]` from the root table. Files are looked up beside the case. Throws
/// InputError.
[[nodiscard]] PackingInput read_packing_scene(TomlTable& root);

/// `file` as named in the case at `case_path`: relative names start at the case's folder.
[[nodiscard]] std::string beside_case(const std::string& case_path, const std::string& file);

/// A table of sizes: distribution = "lognormal", "uniform" or "list", with its numbers.
///   unit  m per length of the table
[[nodiscard]] SizeDistribution read_sizes(TomlTable table, double unit);

/// A unit that the packing file states in its comments goes over `unit`; the case may repeat it but not
/// contradict.
void adopt_stated_unit(const std::string& file, const std::optional<TomlValue>& of_case, double& unit);

}  // namespace superstep
