#pragma once
/// Stability theory of the stabilised families, for the laboratory.

#include <vector>

#include "integrators/schemes/stabilised_schemes.hpp"
#include "integrators/schemes/stability_model.hpp"

namespace superstep {

/// A family as one method offers it.
struct OfferedFamily {
  const StabilisedFamily& (*family)();
  const char* spec_head;  ///< of its SPEC, e.g. "rkc:order=1,"
  int limit_stages;       ///< with which the longest stable step is measured
  bool limit_when_quick;
};

[[nodiscard]] StabilityTheory stabilised_theory(const std::vector<OfferedFamily>& families);

}  // namespace superstep
