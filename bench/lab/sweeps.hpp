#pragma once
/// How bounds, alpha* and overshoot depend on the network and on nu.

#include <vector>

#include "results/study/stability_results.hpp"

namespace superstep {

/// Random networks over conductance contrast (1 to 1e12), size ratio (1 to 100), and nu (1e-6 to 0.5) at
/// contrast 1e6. Each point is the worst of several networks.
[[nodiscard]] std::vector<SweepPoint> sweep_networks(bool quick);

}  // namespace superstep
