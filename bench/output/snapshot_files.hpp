#pragma once
/// The files of particles that a press leaves at its output times.

#include <cstddef>
#include <string>

namespace superstep {

/// "snapshots/particles_0007.csv", relative to the folder of the run.
[[nodiscard]] std::string snapshot_name(std::size_t number);

/// Removes those that an earlier run left in `folder`, from that number on, and nothing else.
void remove_snapshots(const std::string& folder, std::size_t first) noexcept;

}  // namespace superstep
