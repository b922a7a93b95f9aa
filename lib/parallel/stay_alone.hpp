#pragma once
/// For a host whose processes share their work in a way of their own.

namespace superstep {

/// From now on `world()` is this process alone, whatever launched it. Call it before anything else does.
void stay_alone() noexcept;

}  // namespace superstep
