#pragma once
/// The span of a field: largest minus smallest value over all nodes and the whole run. Every tolerance and
/// every score refers to it, so it is one number per field, found before any method runs.

#include <span>
#include <string>
#include <vector>

#include "integrators/integrator.hpp"

namespace superstep {

struct Spans {
  std::vector<double> spans;  ///< [fields] K or V; 0 = nothing moves
  bool pilot = false;         ///< a pilot run found them; else the declared values say it all
  std::string how;            ///< one line for people
};

/// Where no sources act and surroundings lie within what initial and fixed values span, that span is attained
/// and nothing beyond it. Elsewhere a pilot run looks: one method for a scene whatever is measured later,
/// with a tolerance of 1e-2 of the span that it finds, repeated until that moves by less than 5 %.
///   plan  its ranges hold initial and fixed values;  t, y  where the run begins
[[nodiscard]] Spans find_spans(Rhs& rhs, const Plan& plan, double t, std::span<const double> y);

}  // namespace superstep
