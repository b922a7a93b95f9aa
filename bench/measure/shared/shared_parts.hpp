#pragma once
/// Scenes that all processes build together, each its own part.

#include <optional>
#include <string>

#include "bench/measure/shared/shared_scene.hpp"
#include "case/scene.hpp"

namespace superstep {

/// On the root: has a case built by all processes. Nothing where it is not one that they can build like that,
/// or where there is one process. Throws InputError.
///   quiet  nothing is said of a case that asks for it and cannot have it
[[nodiscard]] std::optional<Scene> share_in_parts(const std::string& file, bool quiet);
/// Elsewhere: the part that this process has then. Throws InputError where the root does.
[[nodiscard]] ScenePart take_in_parts(Unpacker& in);
/// The root's own part.
[[nodiscard]] ScenePart part_of_own(const Scene& scene);

}  // namespace superstep
