#pragma once
/// A run over a scene that several processes share.

#include <functional>
#include <string>

#include "bench/measure/run_one.hpp"
#include "bench/measure/shared/shared_scene.hpp"

namespace superstep {

/// On the root: has all processes run the method and gathers what comes out. Throws NeedsWhole where only one
/// that has the whole scene could.
///   plan  for the whole scene, without probes
[[nodiscard]] Outcome run_shared(const Scene& scene, const std::string& spec, const Plan& plan,
                                 const RunRequest& request, const std::function<void()>& stepping_begins,
                                 RunResult& result);
/// Elsewhere: takes part in a run that the root has begun.
void join_run(ScenePart& part, Unpacker& in, const WriteFrame& write_frame);

/// True while the root waits for others in the middle of a run.
[[nodiscard]] bool in_shared_run() noexcept;

}  // namespace superstep
