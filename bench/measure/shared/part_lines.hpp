#pragma once
/// The lines of the final values of a scene that nobody has as a whole: "id,value", with
/// "x,y,z,r" of spheres in between, in the order of the nodes.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "bench/measure/shared/shared_scene.hpp"
#include "case/scene.hpp"

namespace superstep {

struct WrittenLines {
  bool reached = true;                 ///< else a process cannot open the file: nothing was written
  std::optional<std::string> failure;  ///< why a process could not write its lines; they all have stopped
};

/// On the root: has every process write its lines into a file that is there and empty, behind `head` and the
/// lines of the processes before it. Nobody holds more than 16 MB of them.
///   state  of the rows that are here
[[nodiscard]] WrittenLines write_part_lines(const Scene& scene, std::span<const double> state,
                                            std::string_view head, const std::string& file);
/// Elsewhere: writes the own ones.
void join_part_lines(const ScenePart& part, Unpacker& in);

/// On the root, for files that it alone can write: calls each(piece) with the lines of all nodes.
void for_part_lines(const Scene& scene, std::span<const double> state,
                    const std::function<void(std::string_view)>& each);
/// Elsewhere: sends the own ones to the root.
void send_part_lines(const ScenePart& part);

}  // namespace superstep
