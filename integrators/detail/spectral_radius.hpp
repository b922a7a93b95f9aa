#pragma once
/// The spectral radius that stabilised methods step by: sharp where it can be, certified everywhere.

#include "rhs/rhs.hpp"

namespace superstep {

class SpectralRadius {
 public:
  /// Upper bound of the spectral radius at (t, y) [1/s], kept while the values of the right-hand side stand.
  /// Constant blocks: Lanczos, inflated, plus what may come on top; others: the certified bound.
  [[nodiscard]] double at(Rhs& rhs, double t, std::span<const double> y);

 private:
  double value_ = 0;
  std::uint64_t version_ = 0;
};

}  // namespace superstep
