#pragma once
/// A fixed piece of work of the kind that is measured, to tell a slower program from a slower machine.

#include <vector>

#include "rhs/sweep.hpp"

namespace superstep {

/// Sweeps of the reference kernel over a lattice of 24^3 nodes, which no optimisation of the program touches.
class Yardstick {
 public:
  Yardstick();
  /// CPU time of one measurement [s], about a hundredth of a second.
  [[nodiscard]] double seconds();

 private:
  std::vector<std::int64_t> row_begin_;
  std::vector<std::int32_t> column_;
  std::vector<double> rate_, state_, next_;
};

}  // namespace superstep
