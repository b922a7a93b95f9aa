#pragma once
/// One superstep of super-time-stepping on one right-hand side.

#include <string>
#include <vector>

#include "core/state_vector.hpp"
#include "integrators/detail/three_term.hpp"
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

/// State and work vectors of one right-hand side that supersteps.
class SuperstepEngine {
 public:
  void prepare(Rhs& rhs);
  void start(std::span<const double> y) { state_.assign(y.begin(), y.end()); }
  /// One superstep over h from t; `inflow`, when not null, gains what entered.
  void step(const SuperstepPlan& plan, double t, double h, double* inflow);
  [[nodiscard]] std::span<const double> state() const noexcept { return state_; }

 private:
  Rhs* rhs_ = nullptr;
  ThreeTermEngine engine_;
  StateVector state_;
};

}  // namespace superstep
