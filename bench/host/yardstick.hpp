#pragma once
/// A fixed piece of work of the kind that is measured, to tell a slower program from a slower machine.

#include <vector>

#include "rhs/kernels/sweep.hpp"

namespace superstep {

/// Sweeps of the reference kernel over a lattice of 24^3 nodes, which no optimisation of the program touches.
class Yardstick {
 public:
  Yardstick();
  /// CPU time of the work [s], about a hundredth of a second; the mean of as many as fill `at_least` [s].
  [[nodiscard]] double seconds(double at_least = 0);

 private:
  void work();

  std::vector<std::int64_t> row_begin_;
  std::vector<std::int32_t> column_;
  std::vector<double> rate_, state_, next_;
};

}  // namespace superstep
