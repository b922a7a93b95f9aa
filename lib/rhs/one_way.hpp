#pragma once
/// A scene whose first field drives the second through sources alone, seen as its two halves.

#include <span>
#include <vector>

#include "rhs/rhs.hpp"

namespace superstep {

/// The potential drives the temperature by Joule heat, or leaves it alone; nothing leads back. Sweeps of the
/// halves count as sweeps of the whole.
class OneWayCoupling {
 public:
  virtual ~OneWayCoupling() = default;
  /// The potential alone: linear, symmetric.
  [[nodiscard]] virtual Rhs& driver() = 0;
  /// The temperature alone, with the rates that `drive` gave it last.
  [[nodiscard]] virtual Rhs& driven() = 0;
  /// rate [driven size]: what the driver's state v causes at time t [K/s].
  virtual void rate(double t, std::span<const double> v, std::span<double> rate) = 0;
  /// Adds `rate` to the driven half from now on; it must outlive its use. Empty = nothing.
  virtual void drive(std::span<const double> rate) = 0;
  /// The state that the driver tends to, to `residual` of its own size; empty where its inputs change, or
  /// where a source feeds a part that holds on to nothing.
  [[nodiscard]] virtual std::vector<double> steady_driver(double residual) = 0;
};

/// True when the matrix exponential gives the solution: the scene is one linear field with constant
/// coefficients, or falls into two such halves.
[[nodiscard]] bool exactly_solvable(Rhs& rhs);

}  // namespace superstep
