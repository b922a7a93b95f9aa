#pragma once
/// Memory that the machine can give.

#include <cstdint>

namespace superstep {

/// Bytes that a new process can have: what is free, swap included, and no more than its control groups allow.
/// The largest number where the system does not say.
[[nodiscard]] std::uint64_t attainable_memory();

/// From now on more than `bytes` beside what the process has reserved is refused, so that "out of memory" is
/// said, and of several methods the others go on, where the system would kill the process. A lower limit
/// stays.
void keep_to_memory(std::uint64_t bytes);

}  // namespace superstep
