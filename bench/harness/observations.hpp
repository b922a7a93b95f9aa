#pragma once
/// What a benchmark keeps of its runs for charts: probe curves, and a slice through the packing.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "bench/harness/reference.hpp"
#include "bench/measure/probe_set.hpp"
#include "case/scene.hpp"
#include "results/observations.hpp"

namespace superstep {

/// Curves of every probe whose value may change, thinned, with the reference at the same instants.
///   reference  may be null
[[nodiscard]] std::vector<ProbeCurve> probe_curves(const Scene& scene, const ProbeSet& probes,
                                                   const std::string& spec, const ProbeHistory& run,
                                                   const Reference* reference);

/// Collects the fields on the spheres of the vertical mid-plane at some output times.
class SliceRecorder {
 public:
  /// The scene must have a packing and outlive the recorder. Takes the initial state as the first frame.
  explicit SliceRecorder(const Scene& scene);
  /// Output time number `output` with its state.
  void observe(std::size_t output, double t, std::span<const double> state);
  /// What was seen, as values of `source`; the recorder is empty afterwards.
  [[nodiscard]] Slice take(const std::string& source);

 private:
  void add_frames(double t, std::span<const double> state);
  const Scene& scene_;
  Slice slice_;
  std::vector<std::size_t> particles_, outputs_;
};

/// The slice of a reference's states.
[[nodiscard]] Slice slice_of(const Scene& scene, const Reference& reference);

}  // namespace superstep
