#pragma once
/// The stiffest mode of a network: its rate and its shape.

#include <vector>

#include "rhs/rhs.hpp"

namespace superstep {

struct StiffestMode {
  double rate = 0;            ///< lambda_max [1/s]
  double residual = 0;        ///< |A v - lambda v| of the shape [1/s]
  std::vector<double> shape;  ///< norm 1 in the capacities
};

/// Restarted Lanczos with full reorthogonalisation: a few tens of vectors, until the residual is 1e-9 of the
/// rate or the effort is spent. rate = 0 for a network in which nothing changes.
[[nodiscard]] StiffestMode stiffest_mode(Rhs& rhs);

}  // namespace superstep
