#pragma once
/// What the processes besides the root do: they wait for parts of scenes and for runs over them.
///
/// Only the root reads input and talks, so that there is one message where there is one error; it also makes
/// and names all files, some of which the others help to fill.

#include <cstdint>

#include "bench/measure/run_one.hpp"

namespace superstep {

/// First word of what the root sends.
enum class Order : std::uint8_t { scene, parts, run, write_lines, send_lines, end };

/// Serves the root until it ends. Returns the exit code.
///   write_frame  of scenes in parts, where the root wishes it
[[nodiscard]] int serve_the_root(const WriteFrame& write_frame);
/// On the root, at the end: workers that wait go home; those in the middle of a run are ended, because it is
/// the root that could not go on.
void dismiss_workers(int exit_code);

}  // namespace superstep
