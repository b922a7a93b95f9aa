#pragma once
/// The solution that all others are measured against, with its own error bar.

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "bench/probe_set.hpp"
#include "bench/progress.hpp"
#include "integrators/integrator.hpp"
#include "scene/scene.hpp"

namespace superstep {

struct ReferenceRequest {
  std::string spec;
  bool use_cache = true;
  const std::atomic<bool>* stop = nullptr;
};

struct Reference {
  std::string spec;
  std::vector<std::vector<double>> states;  ///< [output times][rhs->size()]
  /// [fields] rms difference, worst over the output times, to the exponential where the scene is linear with
  /// constant coefficients (then it is the reference's own error), else to a run at a tolerance 10 times
  /// looser (a cautious bar); empty when there is neither.
  std::vector<double> error_bar;
  ProbeHistory history;
  bool from_cache = false;
  double cpu_seconds = 0;  ///< of its integrations; 0 from the cache
};

/// What became of a reference: without one, `outcome` says why.
struct ReferenceResult {
  std::optional<Reference> reference;
  Outcome outcome;
  std::vector<std::string> warnings;
};

/// CVODE with KLU; on networks whose factors would be out of proportion the exponential where it is exact,
/// and CVODE with a lighter solver elsewhere.
[[nodiscard]] std::string default_reference(const Scene& scene);

/// Takes the reference from the cache, or integrates it and puts it there. A cache that cannot be written is
/// a warning.
[[nodiscard]] ReferenceResult obtain_reference(const Scene& scene, const ProbeSet& probes,
                                               const ReferenceRequest& request, Progress& progress);

}  // namespace superstep
