#pragma once
/// Process CPU time, wall time and peak memory.

namespace superstep {

/// CPU time of the whole process, all threads [s].
[[nodiscard]] double process_cpu_seconds() noexcept;
/// Monotonic wall time [s].
[[nodiscard]] double wall_seconds() noexcept;
/// Largest resident set of the process so far [MB = 1e6 bytes].
[[nodiscard]] double peak_memory_megabytes() noexcept;

}  // namespace superstep
