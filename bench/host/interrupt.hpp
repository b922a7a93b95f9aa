#pragma once
/// Ctrl-C, and the wishes of shells and batch systems, as a wish to stop cleanly.

#include <atomic>

namespace superstep {

/// From now on SIGINT, SIGTERM, SIGXCPU and, unless it is ignored (nohup), SIGHUP set `stop_flag()`. The
/// third signal ends the program at once. Whoever sends another one than SIGINT does not watch: then the
/// program has ten seconds to stop.
void catch_interrupts();

/// Set by those signals; methods look at it at their step ends.
[[nodiscard]] const std::atomic<bool>& stop_flag() noexcept;

/// Exit code of a run that was interrupted: 128 and the signal, as shells expect; 130 is Ctrl-C.
[[nodiscard]] int interrupted_exit_code() noexcept;

}  // namespace superstep
