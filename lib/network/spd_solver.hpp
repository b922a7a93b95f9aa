#pragma once
/// Direct solver for (shift * C + K) x = b on the free nodes of a network, by CHOLMOD.

#include <memory>
#include <span>
#include <vector>

#include "network/cholmod_factor.hpp"
#include "network/network.hpp"

namespace superstep {

class SpdSolver {
 public:
  /// Factorizes. Every component needs a fixed node or a shift > 0 [1/s]: a singular matrix "factorizes"
  /// without complaint, so connectivity is checked first. Throws NumericalError.
  explicit SpdSolver(const Network& network, double shift = 0.0);
  /// Other conductances on the same graph: keeps the analysis. Throws NumericalError.
  void refactorize(const Network& network, double shift = 0.0);

  /// x [n] for b [n] (W or A with shift 0).
  [[nodiscard]] std::vector<double> solve(std::span<const double> b) const;
  /// Entries of the Cholesky factor.
  [[nodiscard]] std::size_t fill() const noexcept { return factor_->fill(); }

 private:
  std::unique_ptr<CholmodFactor> factor_;
};

/// True when every component of the free network touches a fixed node.
[[nodiscard]] bool every_component_is_held(const Network& network);

/// Steady values on the free nodes [n]: K x = (what sources and fixed values bring in). Throws
/// NumericalError.
[[nodiscard]] std::vector<double> steady_state(const Network& network);

}  // namespace superstep
