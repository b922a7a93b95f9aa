#pragma once
/// [dynamics.particles]: who is in the press.

#include <optional>
#include <vector>

#include "case/press/read_materials.hpp"
#include "case/press/read_model.hpp"
#include "core/text/toml.hpp"

namespace superstep::dynamics {

/// One of: `count` with `radius` or `sizes`, and `seed`, for random sequential addition; a `list` of
/// particles with a position each; a packing `file` in any format, with `bonds` beside it.
/// Generated and read particles are stored bin by bin, for locality.
///   initial [K]
///   seed    goes over the one that the case states
///   placed  told which part of generated particles is placed, where that takes time
void read_particles(TomlTable table, const std::vector<PressMaterial>& materials, double initial,
                    std::optional<std::uint64_t> seed, const Placed& placed, ModelInput& input);

}  // namespace superstep::dynamics
