#pragma once
/// One SPEC on one scene of a corpus: a row of corpus.csv.

#include <cstdint>
#include <string>
#include <vector>

#include "results/results.hpp"

namespace superstep {

struct CorpusRow {
  // the scene
  std::string scene, set, scene_class, kind;
  std::uint64_t unknowns = 0;
  double stiffness = 0, contrast = 1;  ///< t_end times spectral radius; largest over smallest rate
  /// What costs are predicted from: "linear", "one-way", "nonlinear", "coupled", or these with "-steady";
  /// pieces between breakpoints, shapes of inputs, decades between the first output and the last, nonzeros of
  /// the fields' matrices off their diagonals.
  std::string physics;
  double pieces = 1, shapes = 0, output_decades = 0;
  std::uint64_t nonzeros = 0;
  // the method; a scene without a reference has one row, of the reference
  std::string spec, integrator, params, status, reason;
  Number cpu;                     ///< s, of preparation and stepping, median of the samples
  Number cpu_prepare;             ///< s, of that before the first step
  std::vector<double> samples{};  ///< s, of preparation and stepping, one a round
  Number memory;                  ///< MB that the run added to what was in use
  Number error;                   ///< worst rms over fields and output times, over the span of the field
  std::uint64_t sweeps = 0, steps = 0;
  // what it was measured against, and where
  std::string reference;
  Number reference_error;  ///< over the span of the field, the worst of the fields
  std::uint64_t threads = 1;
  double time_limit = 0;  ///< s
  std::string choice;     ///< what the method chose by itself
  std::string processor, revision;
  std::string key;  ///< names scene, build and machine: what has the same key need not be measured again

  [[nodiscard]] bool ok() const noexcept { return status == "ok"; }
};

}  // namespace superstep
