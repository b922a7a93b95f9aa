#pragma once
/// Scenes that all processes build together, layer by layer, and the lines of their final values.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "bench/measure/shared/shared_scene.hpp"
#include "case/scene.hpp"

namespace superstep {

/// On the root: has a case built by all processes. Nothing where it is not one that they can build like that,
/// or where there is one process. Throws InputError.
[[nodiscard]] std::optional<Scene> share_layers(const std::string& file);
/// Elsewhere: the part that this process has then. Throws InputError where the root does.
[[nodiscard]] ScenePart take_layers(Unpacker& in);
/// The root's own part.
[[nodiscard]] ScenePart part_of_layers(const Scene& scene);

/// On the root: calls each(piece) with the lines of all nodes, "id,x,y,z,r,value", in the order of the nodes.
///   state  of the rows that are here
void for_layered_lines(const Scene& scene, std::span<const double> state,
                       const std::function<void(std::string_view)>& each);
/// Elsewhere: sends the own ones to the root.
void send_layered_lines(const ScenePart& part);

}  // namespace superstep
