#pragma once
/// Ctrl-C as a wish to stop cleanly.

#include <atomic>

namespace superstep {

/// Exit code of a run that was interrupted: 128 + SIGINT, as shells expect.
inline constexpr int interrupted_exit_code = 130;

/// From now on SIGINT sets `stop_flag()`; the third one ends the program at once.
void catch_interrupts();

/// Set by Ctrl-C; methods look at it at their step ends.
[[nodiscard]] const std::atomic<bool>& stop_flag() noexcept;

}  // namespace superstep
