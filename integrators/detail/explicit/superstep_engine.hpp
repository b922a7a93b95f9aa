#pragma once
/// One superstep of super-time-stepping on one right-hand side.

#include <string>
#include <vector>

#include "core/state_vector.hpp"
#include "integrators/schemes/three_term.hpp"
#include "rhs/rhs.hpp"

namespace superstep {

/// How a superstep is divided and carried out.
struct SuperstepPlan {
  int n = 1;
  double nu = 0.5;
  std::string order;             ///< recurrence | leja | natural
  std::vector<double> substeps;  ///< [n] in units of the critical step; empty for the recurrence
  ThreeTermScheme scheme;        ///< of the recurrence

  [[nodiscard]] static SuperstepPlan make(int n, double nu, const std::string& order);
};

/// Work vectors of one right-hand side that supersteps.
class SuperstepEngine {
 public:
  void prepare(Rhs& rhs);
  /// One superstep over h from t: y becomes its result.
  void step(const SuperstepPlan& plan, double t, double h, StateVector& y);

 private:
  Rhs* rhs_ = nullptr;
  ThreeTermEngine engine_;
};

}  // namespace superstep
