#pragma once
/// The solution that all others are measured against, with its own error bar.

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "bench/host/progress.hpp"
#include "bench/measure/probe_set.hpp"
#include "bench/measure/run_limits.hpp"
#include "case/scene.hpp"
#include "integrators/integrator.hpp"

namespace superstep {

struct ReferenceRequest {
  std::string spec;  ///< empty = as the scene needs
  bool use_cache = true;
  const std::atomic<bool>* stop = nullptr;
  RunLimits limits = {};  ///< of each of the two runs, and of the pilot runs before them
};

struct Reference {
  std::string spec, check;                  ///< SPECs of the truth and of the other family that checked it
  std::vector<std::vector<double>> states;  ///< [output times][rhs->size()]
  /// [fields] rms, worst over the output times: the truth's own bound where it has one and the check agrees
  /// with it, else the largest distance of the two with a reserve. Never below rounding.
  std::vector<double> error_bar;
  std::vector<double> spans;  ///< [fields] of the scene
  std::string spans_how;
  double cpu_pilot = 0;  ///< s, of the runs that found the spans; as measured when they ran
  /// [output times][rhs->size()] what CVODE found, where it is not the truth itself.
  std::vector<std::vector<double>> cvode;
  ProbeHistory history;
  double inflow = 0;  ///< J or C that entered, sources exactly and fluxes by quadrature along the truth
  bool from_cache = false;
  double cpu_seconds = 0;  ///< of its integrations; 0 from the cache
};

/// What became of a reference: without one, `outcome` says why.
struct ReferenceResult {
  std::optional<Reference> reference;
  Outcome outcome;
  std::vector<std::string> warnings;
};

/// Takes the reference from the cache, or integrates it and puts it there. A cache that cannot be written is
/// a warning.
[[nodiscard]] ReferenceResult obtain_reference(const Scene& scene, const ProbeSet& probes,
                                               const ReferenceRequest& request, Progress& progress);

}  // namespace superstep
