#pragma once
/// Nodes whose history a case asks for.

#include <vector>

#include "case/scene.hpp"
#include "core/text/toml.hpp"

namespace superstep {

/// Reads `probe = "mid-height" | id | [ids]`. Throws InputError for an unknown id, a repeated one, or
/// "mid-height" without coordinates.
[[nodiscard]] std::vector<Probe> read_probes(const TomlValue& probe, const Scene& scene);

}  // namespace superstep
